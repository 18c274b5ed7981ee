// The layers of lighting design: what an eye and what a meter on the surfaces would read.
#pragma once

#include <functional>

#include "options/render_options.h"
#include "options/render_result.h"

namespace pencil {

/// Adds the photometric layers that `options` name to `result`, which was made with them. Illuminance is `lumens_per_watt` times the luminance of
/// irradiance, from one more solve in which all that is seen is white; 0 where nothing is seen.
void add_photometric_layers(const RenderOptions& options, double lumens_per_watt,
                            const std::function<RenderResult(const RenderOptions&)>& solve, RenderResult& result);

}  // namespace pencil
