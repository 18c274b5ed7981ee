#include "thesis/lit_pencils.h"

#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include "line/free_space.h"
#include "line/pencil_solver.h"
#include "pencils/light_samples.h"
#include "scene/formats/load_scene.h"
#include "visibility/rasterize_octahedral.h"

namespace pencil::thesis {

namespace {

using glm::dvec4;
using ref::dvec2;
using ref::dvec3;

constexpr int source_map = 128;  // finer than the maps compared, so that their own resolution shows

RenderOptions render_options(const LookUpOptions& options) {
    RenderOptions out;
    out.method = MethodName::line;
    out.pencils = options.pencils;
    out.map = source_map;
    return out;
}

}  // namespace

std::size_t texel_index(int tile, int x, int y, int n) {
    const int stride = PENCIL_TILE_STRIDE(n);
    return static_cast<std::size_t>(tile) * static_cast<std::size_t>(PENCIL_TILE_TEXELS(n)) +
           static_cast<std::size_t>((y + PENCIL_GUTTER) * stride + x + PENCIL_GUTTER);
}

LitPencils::LitPencils(const std::shared_ptr<Device>& device, const LookUpOptions& options)
    : scene_(load_scene(options.scene)),
      forms_(choose_light_forms(scene_, true, false)),
      flat_(flatten(scene_, forms_, options.resolution, options.resolution)),
      kernels_(device, scene_features(flat_, RenderOptions().film_samples, false)),
      device_scene_(device, flat_),
      film_(kernels_, device_scene_, FilmCamera{flat_.camera, glm::vec3(flat_.eye)}, scene_.sensor.filter, Turn()) {
    make_pencils(device, options);
    const auto capacity = static_cast<std::size_t>(surfels().capacity);
    const std::vector<float> data = surfels().data.read();
    for (std::size_t i = 0; i < static_cast<std::size_t>(surfels().count); ++i)
        positions_.emplace_back(data[SURFEL_X * capacity + i], data[SURFEL_Y * capacity + i], data[SURFEL_Z * capacity + i]);
}

/// Pencils as a render makes them, lit directly; radiance and distances are read back.
void LitPencils::make_pencils(const std::shared_ptr<Device>& device, const LookUpOptions& options) {
    const RenderOptions settings = render_options(options);
    StageClock clock(device, {});
    LightSet lights(device, sample_lights(scene_, flat_, forms_, settings.light_samples, 0), settings.map);
    rasterize_octahedral(kernels_, device_scene_, lights.maps, 0, lights.maps.count);
    FreeSpace free_space(kernels_, device_scene_, flat_, surfels(), &lights.maps, settings.map);
    const auto candidates = make_candidate_source({kernels_, device_scene_, scene_, flat_, settings.seed}, {Placement::lds});
    PencilSolver solver(kernels_, device_scene_, free_space, *candidates, lights, settings, clock);
    set_ = solver.create(0, nullptr, false, true);
    solver.fill(set_, nullptr, false, true, false);
    radiance_ = set_.radiance.read();
    hits_ = set_.maps->hits.read();
    host_cops_ = set_.maps->cops.read();
}

/// Radiance (rgb) by interpolation and distance (w) of the nearest texel, in a direction from a pencil.
dvec4 LitPencils::seen(int pencil, const dvec3& direction) const {
    const ref::Footprint f = ref::bilinear_footprint(ref::direction_to_oct(direction), source_map);
    const auto at = [&](int dx, int dy) { return dvec4(radiance_[texel_index(pencil, f.x + dx, f.y + dy, source_map)]); };
    const dvec4 light = glm::mix(glm::mix(at(0, 0), at(1, 0), f.fx), glm::mix(at(0, 1), at(1, 1), f.fx), f.fy);
    const ref::Texel t = ref::direction_to_texel(direction, source_map);
    const double disparity = hits_[texel_index(pencil, t.x, t.y, source_map)].disparity;
    const double length = glm::length(ref::texel_direction(t.x, t.y, source_map));
    return {dvec3(light), disparity > 0.0 ? length / disparity : 0.0};
}

std::vector<float4> LitPencils::fill(const ref::Map& map, int n) const {
    const int pencils = static_cast<int>(host_cops_.size());
    const std::size_t tiles = host_cops_.size() * static_cast<std::size_t>(map.tiles);
    std::vector<float4> texels(tiles * static_cast<std::size_t>(PENCIL_TILE_TEXELS(n)));
    for (int tile = 0; tile < map.tiles; ++tile)
        for (int y = -1; y <= n; ++y)
            for (int x = -1; x <= n; ++x) {
                const dvec3 direction = map.stored_direction(tile, x, y, n);
                for (int i = 0; i < pencils; ++i) texels[texel_index(i * map.tiles + tile, x, y, n)] = float4(seen(i, direction));
            }
    return texels;
}

}  // namespace pencil::thesis
