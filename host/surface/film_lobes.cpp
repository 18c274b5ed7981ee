#include "surface/film_lobes.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "surface/add_reflections.h"
#include "surface/light_lobes.h"

namespace pencil {

namespace {

/// Chains along the lobes of a surfel of the film in a pass: as many as make this share of the rays of film pencils, from 4 to 64.
constexpr double chain_share = 0.6;

int chains_per_surfel(double film_rays, std::size_t surfels) {
    return static_cast<int>(std::lround(std::clamp(chain_share * film_rays / static_cast<double>(surfels), 4.0, 64.0)));
}

/// Surfels whose material scatters along lobes.
std::vector<int> surfels_with_lobes(const Surfels& surfels, const std::vector<Material>& materials) {
    static_assert(sizeof(int) == sizeof(float), "rows are stored as the bits of floats");
    const std::vector<float> bits = surfels.data.read(
        static_cast<std::size_t>(SURFEL_MATERIAL) * static_cast<std::size_t>(surfels.capacity), static_cast<std::size_t>(surfels.count));
    std::vector<int> found;
    for (std::size_t i = 0; i < bits.size(); ++i) {
        int row = 0;
        std::memcpy(&row, &bits[i], sizeof row);
        if (row == PENCIL_NO_MATERIAL) continue;
        const int model = materials[static_cast<std::size_t>(row < 0 ? ~row : row)].model;
        if (model != MATERIAL_DIFFUSE) found.push_back(static_cast<int>(i));
    }
    return found;
}

/// Chains that are followed at once, about: bounds memory (30 MB) and the length of a launch.
constexpr std::size_t chunk_chains = std::size_t{1} << 18;

/// Some of the surfels, each `times` times.
std::vector<int> repeated(const std::vector<int>& surfels, std::size_t first, std::size_t count, int times) {
    std::vector<int> all;
    all.reserve(count * static_cast<std::size_t>(times));
    for (std::size_t i = first; i < first + count; ++i) all.insert(all.end(), static_cast<std::size_t>(times), surfels[i]);
    return all;
}

}  // namespace

void add_film_lobes(RenderContext& context, Frame& frame, SurfaceSolver& solver, const FilmLobes& lobes) {
    const Surfels& surfels = frame.film().surfels();
    const std::vector<int> with_lobes = surfels_with_lobes(surfels, context.flat.materials);
    if (with_lobes.empty()) return;
    const auto& device = context.kernels.device();
    const int shared = chains_per_surfel(lobes.film_rays, with_lobes.size());
    const std::size_t chunk = std::max(chunk_chains / static_cast<std::size_t>(shared), std::size_t{1});
    for (std::size_t first = 0; first < with_lobes.size(); first += chunk) {
        const std::size_t count = std::min(chunk, with_lobes.size() - first);
        const Buffer<int> starts(device, repeated(with_lobes, first, count, shared), "starts of chains");
        const Chains chains = solver.follow(surfels, starts, {shared, !lobes.drawn});
        add_reflections(context.kernels, chains, solver.radiance(chains.ends), starts, shared, lobes.before, surfels.capacity,
                        frame.outgoing());
    }
    // After the chains, which look at what film pencils have added.
    if (frame.lights().maps.count > 0 && !lobes.drawn)
        light_lobes(context.kernels, context.device_scene, surfels, Buffer<int>(device, with_lobes, "surfels with lobes"), shared,
                    frame.lights(), frame.outgoing());
}

}  // namespace pencil
