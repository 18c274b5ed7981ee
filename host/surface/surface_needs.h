// What pencils on surfaces need before their first pass.
#pragma once

#include "film/method.h"
#include "options/render_options.h"
#include "scene/scene.h"

namespace pencil {

/// Hierarchy and rays; no maps.
MethodNeeds surface_needs(const Scene& scene, const std::vector<LightForm>& forms, const RenderOptions& options);

}  // namespace pencil
