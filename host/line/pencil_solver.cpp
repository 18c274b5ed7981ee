#include "line/pencil_solver.h"

#include <algorithm>
#include <cmath>

#include "film/emit_surfels.h"
#include "film/light_surfels.h"
#include "line/estimate_density.h"
#include "line/expand_maps.h"
#include "line/free_path_density.h"
#include "line/gather_surfels.h"
#include "line/planned_maps.h"
#include "line/project_pencils.h"
#include "line/store_radiance.h"
#include "line/sum_radiance.h"
#include "line/test_visibility.h"
#include "visibility/geometry_maps.h"

namespace pencil {

namespace {

/// Surfels of maps that are worked on at once: bounds memory and the length of a launch.
constexpr int chunk_surfels = 1 << 20;
/// Masks of one chunk take at most this much [bytes].
constexpr std::size_t mask_bytes = std::size_t{128} << 20;

int chunk_tiles(int map_texels, int pencils) {
    const auto texels = static_cast<std::size_t>(map_texels);
    const std::size_t by_mask = mask_bytes / (sizeof(uint) * static_cast<std::size_t>(mask_words(pencils)) * texels);
    const std::size_t by_surfels = chunk_surfels / texels;
    return static_cast<int>(std::clamp<std::size_t>(std::min(by_mask, by_surfels), 1, static_cast<std::size_t>(pencils)));
}

}  // namespace

PencilSolver::PencilSolver(Kernels& kernels, const DeviceScene& scene, FreeSpace& free_space, CandidateSource& candidates,
                           const LightSet& lights, const RenderOptions& options, StageClock& clock)
    : kernels_(kernels),
      scene_(scene),
      free_space_(free_space),
      candidates_(candidates),
      lights_(lights),
      options_(options),
      clock_(clock),
      tables_(kernels) {}

PencilSet PencilSolver::create(int index, const PencilSet* source, bool emission, bool direct) {
    PencilSet set;
    const PowerSeen power = [&](std::shared_ptr<GeometryMaps> maps) { return power_seen(std::move(maps), source, emission, direct); };
    times_.maps += clock_.run("pencil maps", [&] {
        set = PencilSet(kernels_.device(), free_space_.create(kernels_, candidates_, set_size(options_, index), index, power));
    });
    return set;
}

PencilSet PencilSolver::create_at(const std::vector<float4>& centres) {
    auto maps = std::make_shared<GeometryMaps>(kernels_.device(), centres, kernels_.map_shape(options_.map), "pencil");
    times_.maps += clock_.run("pencil maps", [&] { make_geometry_maps(kernels_, scene_, *maps, 0, maps->count); });
    return PencilSet(kernels_.device(), std::move(maps));
}

void PencilSolver::replace(const PencilSet& set, const std::vector<int>& tiles, const std::vector<float4>& centres) {
    GeometryMaps made(kernels_.device(), centres, set.maps->shape, "pencil");
    clock_.run("pencil maps", [&] {
        make_geometry_maps(kernels_, scene_, made, 0, made.count);
        for (std::size_t k = 0; k < tiles.size(); ++k) set.maps->copy_tile(made, static_cast<int>(k), tiles[k]);
    });
}

/// Mean radiance of maps that are not kept.
std::vector<float4> PencilSolver::power_seen(std::shared_ptr<GeometryMaps> maps, const PencilSet* source, bool emission, bool direct) {
    PencilSet probes(kernels_.device(), std::move(maps));
    const int texels = probes.maps->texels(), tiles = std::min(chunk_surfels / texels, probes.maps->count);
    Surfels surfels(kernels_, tiles * texels, "surfels of probes");
    Buffer<float> outgoing = surfel_rgb(kernels_.device(), surfels.capacity, "radiance of probes");
    Buffer<int> visible(kernels_.device(), static_cast<std::size_t>(surfels.capacity), "visible pencils");
    for (int first = 0; first < probes.maps->count; first += tiles) {
        const int count = std::min(tiles, probes.maps->count - first);
        send(*probes.maps, first, count, source, emission, direct, surfels, outgoing, visible);
        store_radiance(kernels_, surfels, outgoing, first, count, probes);
    }
    return mean_radiance(kernels_, probes);
}

/// What texels of tiles first .. first + count send to their centres.
void PencilSolver::send(const GeometryMaps& maps, int first, int count, const PencilSet* source, bool emission, bool direct,
                        Surfels& surfels, Buffer<float>& outgoing, Buffer<int>& visible) {
    gather_surfels(kernels_, scene_, maps, first, count, surfels);
    outgoing.fill_zero();
    if (emission) emit_surfels(kernels_, scene_, surfels, true, outgoing);
    if (direct) light_surfels(kernels_, scene_, surfels, lights_, outgoing, "direct light to pencils");
    if (!source) return;
    RayChoice rays = map_rays(options_, sets_);
    rays.first_key = static_cast<std::uint32_t>(first) * static_cast<std::uint32_t>(maps.texels());
    project(surfels, *source, rays, outgoing, visible, "pencil transport");
}

PencilSet PencilSolver::reflect(const PencilSet& set, bool direct) {
    PencilSet next(kernels_.device(), set.maps);
    next.light_maps = set.light_maps;
    next.weight_maps = set.weight_maps;
    if (weights_in_maps(form()))
        next.radiance.copy_from(set.radiance, 0, 0, set.radiance.size());  // the quadrature weights stay, the radiance is overwritten
    fill(next, &set, false, direct, false);
    return next;
}

void PencilSolver::project(const Surfels& surfels, const PencilSet& source, const RayChoice& rays, Buffer<float>& outgoing,
                           Buffer<int>& visible, const std::string& what) {
    const bool sends = weights_need_rays(form());
    const RayStretch stretch = sends ? ray_stretch(kernels_, rays, source.maps->count) : RayStretch{std::max(surfels.count, 1), 0};
    for (int first = 0; first < surfels.count; first += stretch.surfels) {
        const int end = std::min(first + stretch.surfels, surfels.count);
        if (sends) project_rays(kernels_, scene_, surfels, first, end, source, free_space_.space(), rays, stretch, tables_.rays());
        if (sends && rays.alone)
            sum_rays(kernels_, surfels, first, end, tables_.rays(), outgoing);
        else
            project_pencils(kernels_, scene_, surfels, first, end, source, tables_, outgoing, visible, what);
    }
}

/// Visibility masks of the surfels, where weights need any.
Buffer<uint> PencilSolver::masks(const Surfels& surfels, int pencils) const {
    if (!weights_need_masks(form())) return {};
    return {kernels_.device(), static_cast<std::size_t>(surfels.capacity) * static_cast<std::size_t>(mask_words(pencils)),
            "visibility masks"};
}

/// Weights of tiles first .. first + count; surfels: what their texels see, for forms that need masks; seen: the maps that tell what these see.
void PencilSolver::weigh_tiles(PencilSet& target, const GeometryMaps& seen, int first, int count, const Surfels& surfels,
                               Buffer<uint>& mask) {
    if (!weights_need_masks(form())) return free_path_density(kernels_, first, count, free_space_.space(), target);
    test_visibility(kernels_, scene_, surfels, seen, mask);
    estimate_density(kernels_, surfels, mask, first, target);
}

/// Geometry maps of the set's pencils at another size.
std::shared_ptr<GeometryMaps> PencilSolver::coarse_maps(const PencilSet& set, int width) {
    auto maps = std::make_shared<GeometryMaps>(kernels_.device(), set.maps->cops.read(), kernels_.map_shape(width), "coarse pencil");
    clock_.run("pencil maps", [&] { make_geometry_maps(kernels_, scene_, *maps, 0, maps->count); });
    return maps;
}

void PencilSolver::weigh(PencilSet& target) {
    if (!weights_in_maps(form())) return;
    if (weights_need_rays(form()) || !has_coarse(options_.density_map, target)) return weigh_texels(target, *target.maps);
    if (!target.weight_maps) target.weight_maps = coarse_maps(target, options_.density_map);
    PencilSet coarse(kernels_.device(), target.weight_maps);
    coarse.radiance.fill_zero();
    weigh_texels(coarse, *target.maps);
    clock_.run("pencil density", [&] { expand_maps(kernels_, scene_, coarse, MapPart::weights, target); });
}

/// Of the target's own texels.
void PencilSolver::weigh_texels(PencilSet& target, const GeometryMaps& seen) {
    const bool by_masks = weights_need_masks(form());
    const int texels = target.maps->texels(), tiles = by_masks ? chunk_tiles(texels, target.maps->count) : target.maps->count;
    Surfels surfels = by_masks ? Surfels(kernels_, tiles * texels, "surfels of pencil maps") : Surfels();
    Buffer<uint> mask = masks(surfels, target.maps->count);
    for (int first = 0; first < target.maps->count; first += tiles)
        clock_.run("pencil density", [&] {
            const int count = std::min(tiles, target.maps->count - first);
            if (by_masks) gather_surfels(kernels_, scene_, *target.maps, first, count, surfels);
            weigh_tiles(target, seen, first, count, surfels, mask);
        });
}

void PencilSolver::fill(PencilSet& target, const PencilSet* source, bool emission, bool direct, bool weights) {
    ++sets_;
    const bool coarse_light = has_coarse(options_.radiance_map, target), coarse_weights = has_coarse(options_.density_map, target);
    if (!coarse_light && !(weights && coarse_weights)) return fill_texels(target, source, emission, direct, weights);
    if (weights) weigh(target);
    if (!coarse_light) return fill_texels(target, source, emission, direct, false);
    if (!target.light_maps) target.light_maps = coarse_maps(target, options_.radiance_map);
    PencilSet light(kernels_.device(), target.light_maps);
    light.radiance.fill_zero();
    fill_texels(light, source, emission, direct, false);
    clock_.run("pencil transport", [&] { expand_maps(kernels_, scene_, light, MapPart::light, target); });
}

/// The target's own texels, weights chunk by chunk with the light.
void PencilSolver::fill_texels(PencilSet& target, const PencilSet* source, bool emission, bool direct, bool weights) {
    const auto& device = kernels_.device();
    const int tiles = chunk_tiles(target.maps->texels(), target.maps->count);
    Surfels surfels(kernels_, tiles * target.maps->texels(), "surfels of pencil maps");
    Buffer<float> outgoing = surfel_rgb(device, surfels.capacity, "radiance of pencil maps");
    Buffer<int> visible(device, static_cast<std::size_t>(surfels.capacity), "visible pencils");
    const bool density = weights && weights_in_maps(form());
    Buffer<uint> mask = density ? masks(surfels, target.maps->count) : Buffer<uint>();
    for (int first = 0; first < target.maps->count; first += tiles) {
        const int count = std::min(tiles, target.maps->count - first);
        times_.transport += clock_.run(source ? "pencil transport" : "initial gather", [&] {
            send(*target.maps, first, count, source, emission, direct, surfels, outgoing, visible);
            if (!density) store_radiance(kernels_, surfels, outgoing, first, count, target);
        });
        if (!density) continue;
        clock_.run("pencil density", [&] {
            weigh_tiles(target, *target.maps, first, count, surfels, mask);
            store_radiance(kernels_, surfels, outgoing, first, count, target);
        });
    }
}

}  // namespace pencil
