// The geometry maps of a render before any is made: what the choice of a visibility path goes by.
#pragma once

#include <vector>

#include "pencils/flat_scene.h"
#include "render/render.h"
#include "visibility/visibility_path.h"

namespace pencil {

/// Pencils of set number `index`: --pencils shrunk by --decay, not below 16 or --pencils.
int set_size(const RenderOptions& options, int index);

/// Maps of light samples, and of the camera and all pencil sets; empty for the surface method, which makes none, and for emission only.
/// How many sets there will be is known only where --bounces says so or one set serves all; else eight are expected.
std::vector<MapBatch> planned_maps(const Scene& scene, const std::vector<LightForm>& forms, const RenderOptions& options);

}  // namespace pencil
