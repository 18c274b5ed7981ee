#include "surface/film_lobes.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "surface/add_reflections.h"
#include "surface/light_lobes.h"

namespace pencil {

namespace {

/// Chains along the lobes of a surfel of the film in a pass: as many as make this share of the rays of film pencils, from 4 to 64.
constexpr double chain_share = 0.25;

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

std::vector<int> repeated(const std::vector<int>& values, int times) {
    std::vector<int> all;
    all.reserve(values.size() * static_cast<std::size_t>(times));
    for (const int value : values) all.insert(all.end(), static_cast<std::size_t>(times), value);
    return all;
}

}  // namespace

void add_film_lobes(RenderContext& context, Frame& frame, SurfaceSolver& solver, double film_rays, bool drawn) {
    const Surfels& surfels = frame.film().surfels();
    const std::vector<int> with_lobes = surfels_with_lobes(surfels, context.flat.materials);
    if (with_lobes.empty()) return;
    const auto& device = context.kernels.device();
    if (const int count = frame.lights().maps.count; count > 0 && !drawn)
        light_lobes(context.kernels, context.device_scene, surfels, Buffer<int>(device, with_lobes, "surfels with lobes"), frame.lights(),
                    frame.outgoing());
    const int shared = chains_per_surfel(film_rays, with_lobes.size());
    const Buffer<int> starts(device, repeated(with_lobes, shared), "starts of chains");
    Surfels chains(context.kernels, static_cast<int>(starts.size()), "ends of chains");
    const Buffer<float> radiance = solver.follow(surfels, starts, shared, chains);
    add_reflections(context.kernels, radiance, chains, starts, shared, surfels.capacity, frame.outgoing());
}

}  // namespace pencil
