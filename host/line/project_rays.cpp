#include "line/project_rays.h"

#include <algorithm>
#include <cmath>

#include "line/free_path_density.h"
#include "pencils/low_discrepancy.h"

namespace pencil {

namespace {

/// Surfels of a film send so many times as many rays as those of maps.
constexpr int film_to_map = 4;
/// The random series of films begin here, beyond those of maps.
constexpr int first_film_series = 1 << 20;
/// A ray through the hierarchy takes about as long as a look at so many pencils.
constexpr double trace_cost = 1024;
/// What a compute unit does in less than a tenth of a second, in looks at pencils.
constexpr double cpu_looks = 1 << 26, gpu_looks = 1 << 30;
/// Work-items of the projection that follows, of a compute unit. Those of a CPU hold many surfels and are fewer where each surfel has much to do:
/// so many pencils and rays together.
constexpr double fewest_cpu_items = 2, most_cpu_items = 16, cpu_sites = 4096, gpu_items = 512;
/// Part of the device's memory that rays may take.
constexpr double memory_part = 16;

RayChoice choose_rays(const RenderOptions& options, int rays, int series) {
    const auto side = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(rays))));
    return {side, static_cast<std::uint32_t>(hash64(hash64(options.seed) ^ static_cast<std::uint64_t>(series))), 0, false};
}

}  // namespace

RayChoice film_rays(const RenderOptions& options, int index) {
    const double share = std::max(std::pow(options.decay, index), 1.0 / film_to_map);
    return choose_rays(options, static_cast<int>(std::ceil(share * options.rays)), first_film_series + index);
}

RayChoice map_rays(const RenderOptions& options, int index) {
    RayChoice choice = choose_rays(options, (options.rays + film_to_map - 1) / film_to_map, index);
    choice.alone = true;
    return choice;
}

RayStretch ray_stretch(const Kernels& kernels, const RayChoice& choice, int pencils) {
    const DeviceInfo& device = kernels.device()->info();
    const double looks = device.compute_units * (device.is_cpu ? cpu_looks : gpu_looks), at_once = looks / (trace_cost + pencils);
    const double item = kernels.block() * kernels.device()->packet_width();  // surfels
    const double items = device.is_cpu ? std::clamp(cpu_sites / (pencils + choice.count()), fewest_cpu_items, most_cpu_items) : gpu_items;
    const double enough = item * device.compute_units * items;
    const auto ray_bytes = static_cast<double>(RAY_FIELDS * sizeof(float));
    const double held = static_cast<double>(device.global_memory) / memory_part / (ray_bytes * choice.count());
    const double wanted = choice.alone ? at_once / choice.count() : enough;  // a sum of rays alone is nothing beside the rays
    const double surfels = std::min({wanted, held, at_once}), most = 1 << 30;
    return {std::max(static_cast<int>(std::min(surfels, most)) / surfel_multiple, 1) * surfel_multiple,
            static_cast<int>(std::min(at_once, most))};
}

void project_rays(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, int first, int end, const PencilSet& source,
                  const CentreSpace& space, const RayChoice& choice, const RayStretch& stretch, SurfelRays& rays) {
    rays.count = choice.count();
    rays.capacity = surfel_capacity(end - first);
    const std::size_t floats =
        static_cast<std::size_t>(rays.count) * static_cast<std::size_t>(rays.capacity) * static_cast<std::size_t>(RAY_FIELDS);
    if (rays.data.size() < floats) {
        rays.data = Buffer<float>(kernels.device(), floats, "rays of surfels");
        rays.data.fill_zero();  // surfels that fill up the last block read what was never sent
    }
    rays.volume = std::get<float>(even_density(space));
    const GeometryMaps& maps = *source.maps;
    const std::size_t packets = kernels.packets(end - first);
    const int step = std::max(stretch.launch / std::max(end - first, 1), 1);
    for (int ray = 0; ray < rays.count; ray += step) {
        const int last = std::min(ray + step, rays.count);
        kernels.get("project_rays")
            .args(surfels.store(), first, end, choice.seed, choice.first_key, choice.side, ray, last, maps.centres(), source.radiance,
                  visibility_map(maps, scene), scene.hierarchy(), even_density(space), rays.data, rays.capacity)
            .run(packets * static_cast<std::size_t>(last - ray), "rays of surfels");
    }
}

void sum_rays(Kernels& kernels, const Surfels& surfels, int first, int end, const SurfelRays& rays, Buffer<float>& outgoing) {
    kernels.get("sum_rays")
        .args(surfels.store(), first, end, rays.data, rays.capacity, rays.count, outgoing)
        .run(kernels.packets(end - first), "rays of surfels");
}

}  // namespace pencil
