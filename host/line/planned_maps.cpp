#include "line/planned_maps.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "shared/map_kind.h"

namespace pencil {

namespace {

/// Sets of a series that is not limited: the tolerance ends it.
constexpr int expected_sets = 8;
/// No level has fewer pencils than this, unless the finest one has.
constexpr int coarsest_level = 32;
/// Tiles of light samples are finer than pencil maps, because shadow edges are seen directly, but not finer than this.
constexpr int light_map_factor = 4;
constexpr int largest_light_map = 256;

bool any_emitter(const Scene& scene, const std::vector<LightForm>& forms, LightForm form) {
    for (std::size_t i = 0; i < forms.size(); ++i)
        if (scene.shapes[i].emits && forms[i] == form) return true;
    return false;
}

/// Sets that carry what is wanted: the first carries order 1 where maps emit, else order 2.
int planned_sets(const RenderOptions& options, bool maps_emit) {
    const int wanted = options.bounces < 0 ? expected_sets : options.bounces - (maps_emit ? 0 : 1);
    return std::clamp(wanted, 0, options.iterate == Iterate::sets ? expected_sets : 1);
}

}  // namespace

int kernel_map_kind(MapKind kind) {
    switch (kind) {
        case MapKind::pyramid:
            return PENCIL_MAP_PYRAMID;
        case MapKind::cube:
            return PENCIL_MAP_CUBE;
        case MapKind::paraboloid:
            return PENCIL_MAP_PARABOLOID;
        case MapKind::octahedral:
            break;
    }
    return PENCIL_MAP_OCTAHEDRAL;
}

int light_map_size(int map) { return std::max(map, std::min(light_map_factor * map, largest_light_map)); }

int set_size(const RenderOptions& options, int index) {
    const double size = options.pencils * std::pow(options.decay, index);
    return std::max(static_cast<int>(std::lround(size)), std::min(options.pencils, options.least_pencils));
}

namespace {

/// As group_leaders splits them.
int groups_of(int pencils) { return pencils <= level_group ? 1 : groups_of(pencils / 2) + groups_of(pencils - pencils / 2); }

}  // namespace

std::vector<int> level_sizes(int pencils) {
    std::vector<int> sizes{pencils};
    for (int next = groups_of(pencils); next >= coarsest_level && next < sizes.back(); next = groups_of(next)) sizes.push_back(next);
    return sizes;
}

std::vector<MapBatch> planned_maps(const Scene& scene, const std::vector<LightForm>& forms, const RenderOptions& options) {
    std::vector<MapBatch> batches;
    if (options.bounces == 0) return batches;
    if (!scene.point_lights.empty() || any_emitter(scene, forms, LightForm::samples))
        batches.push_back({options.light_samples, light_map_size(options.map)});
    const int sets = options.field ? 1 : planned_sets(options, any_emitter(scene, forms, LightForm::maps));
    int pencils = 1;  // the camera's map finds rooms
    for (int index = 0; index < sets; ++index) pencils += set_size(options, index);
    if (options.iterate == Iterate::levels && !options.field) {
        const std::vector<int> levels = level_sizes(options.pencils);
        pencils = std::accumulate(levels.begin(), levels.end(), 1);
    }
    if (sets > 0) batches.push_back({pencils, options.map});
    for (const int own : {options.radiance_map, options.density_map})
        if (sets > 0 && own > 0 && own < options.map) batches.push_back({pencils, own});
    return batches;
}

}  // namespace pencil
