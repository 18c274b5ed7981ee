#include "line/project_rays.h"

#include <algorithm>
#include <cmath>

#include "line/free_path_density.h"
#include "pencils/low_discrepancy.h"

namespace pencil {

namespace {

/// Rays of one launch: a fraction of a second on a CPU.
constexpr int launch_rays = 1 << 18;
/// Surfels of a film send so many times as many rays as those of maps.
constexpr int film_to_map = 4;
/// Numbers of sets are below this.
constexpr int many = 1 << 20;

RayChoice choose_rays(const RenderOptions& options, int rays, int index) {
    const auto side = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(rays))));
    return {side, static_cast<std::uint32_t>(hash64(hash64(options.seed) ^ static_cast<std::uint64_t>(index))), 0, false};
}

}  // namespace

RayChoice film_rays(const RenderOptions& options, int index) {
    const double share = std::max(std::pow(options.decay, index), 1.0 / film_to_map);
    return choose_rays(options, static_cast<int>(std::ceil(share * options.rays)), many + index);
}

RayChoice map_rays(const RenderOptions& options, int index) {
    RayChoice choice = choose_rays(options, (options.rays + film_to_map - 1) / film_to_map, index);
    choice.alone = true;
    return choice;
}

int ray_stretch(const RayChoice& choice) { return std::max(launch_rays / choice.count() / surfel_multiple, 1) * surfel_multiple; }

void project_rays(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, int first, int end, const PencilSet& source,
                  const CentreSpace& space, const RayChoice& choice, SurfelRays& rays) {
    rays.count = choice.count();
    rays.capacity = ray_stretch(choice);
    const std::size_t floats =
        static_cast<std::size_t>(rays.count) * static_cast<std::size_t>(rays.capacity) * static_cast<std::size_t>(RAY_FIELDS);
    if (rays.data.size() < floats) rays.data = Buffer<float>(kernels.device(), floats, "rays of surfels");
    rays.volume = std::get<float>(even_density(space));
    const GeometryMaps& maps = *source.maps;
    kernels.get("project_rays")
        .args(surfels.store(), first, end, choice.seed, choice.first_key, choice.side, maps.centres(), source.radiance,
              visibility_map(maps, scene), scene.hierarchy(), even_density(space), rays.data, rays.capacity)
        .run(kernels.packets(end - first), "rays of surfels");
}

void sum_rays(Kernels& kernels, const Surfels& surfels, int first, int end, const SurfelRays& rays, Buffer<float>& outgoing) {
    kernels.get("sum_rays")
        .args(surfels.store(), first, end, rays.data, rays.capacity, rays.count, outgoing)
        .run(kernels.packets(end - first), "rays of surfels");
}

}  // namespace pencil
