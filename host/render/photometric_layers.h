// The layers of lighting design: what an eye and what a meter on the surfaces would read.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "options/layer.h"
#include "options/render_options.h"
#include "scene/scene.h"

namespace pencil {

/// The image of a solve for irradiance, and what became of the solve.
struct IrradianceImage {
    std::vector<Layer> layers;  // irradiance / pi first; none if it was stopped before
    std::vector<std::string> warnings;
    bool interrupted = false;
    bool converged = true;
};

/// `options` for irradiance instead of radiance: of the surface method, which alone knows it; its film is the same.
RenderOptions irradiance_options(RenderOptions options);

/// Adds the photometric layers that `aovs` name to the layers of an image, beauty first. Illuminance is `lumens_per_watt` times the luminance of
/// irradiance, from one more solve in which all that is seen is white; 0 where nothing is seen. Returns what that solve said, its warnings with the
/// layer's name before them.
IrradianceImage add_photometric_layers(const std::vector<std::string>& aovs, double lumens_per_watt,
                                       const std::function<IrradianceImage()>& solve, std::vector<Layer>& layers);

/// A warning if some lights of the scene were given in lumens or candela and others were not, and no efficacy is `asked` for: one factor makes
/// lumens of both. Else nothing.
std::vector<std::string> mixed_lights(const Scene& scene, double asked);

}  // namespace pencil
