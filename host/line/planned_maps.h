// The geometry maps of a render before any is made: what the choice of a visibility path goes by.
#pragma once

#include <vector>

#include "options/render_options.h"
#include "pencils/flat_scene.h"
#include "visibility/visibility_path.h"

namespace pencil {

/// Pencils of set number `index`: --pencils shrunk by --decay, not below --least-pencils or --pencils.
int set_size(const RenderOptions& options, int index);

/// Pencils of a group, of which one goes on to the next level.
constexpr int level_group = 4;
/// Numbers of pencils of the levels, the finest first; bounces that are limited may need fewer levels.
std::vector<int> level_sizes(int pencils);

/// The value of PENCIL_MAP_KIND.
int kernel_map_kind(MapKind kind);

/// Width of the maps of light samples beside pencil maps of width `map`.
int light_map_size(int map);

/// Maps of light samples, and of the camera and all pencil sets; empty for emission only.
/// How many sets there will be is known only where --bounces says so or one set serves all; else eight are expected.
std::vector<MapBatch> planned_maps(const Scene& scene, const std::vector<LightForm>& forms, const RenderOptions& options);

}  // namespace pencil
