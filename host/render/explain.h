// Decisions of a render in plain sentences, for --explain: what was chosen and why, and what the scene does not need.
#pragma once

#include <string>
#include <vector>

#include "pencils/flat_scene.h"
#include "device/features.h"
#include "render/render.h"

namespace pencil {

/// `maps`: the sentence about geometry maps, empty if none are made.
std::vector<std::string> explain(const Scene& scene, const RenderOptions& options, const std::vector<LightForm>& forms,
                                 const Features& features, const std::string& maps, const Device& device);

}  // namespace pencil
