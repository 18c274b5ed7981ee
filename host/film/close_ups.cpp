#include "film/close_ups.h"

#include <algorithm>
#include <cmath>

#include "pencils/low_discrepancy.h"

namespace pencil {

namespace {

/// About a sample at most, and in all at least where that is few beside a render.
constexpr int most_each = 16, few_surfels = 1 << 15;

/// Steps from a sample through its share of a pixel.
std::vector<glm::vec2> steps_about(int each, int samples, const Turn& turn) {
    const glm::dvec2 shift(random_unit(turn.seed, 105, turn.index), random_unit(turn.seed, 106, turn.index));
    const double width = 1 / std::sqrt(static_cast<double>(samples));
    std::vector<glm::vec2> steps;
    steps.reserve(static_cast<std::size_t>(each));
    for (int k = 0; k < each; ++k) steps.emplace_back(width * (r2_sequence(static_cast<std::uint64_t>(k), shift) - 0.5));
    return steps;
}

}  // namespace

CloseUps look_closely(Kernels& kernels, const DeviceScene& scene, const FilmSamples& film, const std::vector<int>& pixels, int film_surfels,
                      const Turn& turn) {
    CloseUps close;
    if (!scene.has_bvh || pixels.empty()) return close;
    const auto& device = kernels.device();
    const int looked_at = static_cast<int>(pixels.size()) * film.count;
    const int each = std::min(std::max(film_surfels, few_surfels) / looked_at, most_each);
    if (each < 2) return close;
    close.each = each;
    close.samples = film.count;
    close.pixels = Buffer<int>(device, pixels, "pixels that are looked at closely");
    close.surfels = Surfels(kernels, looked_at * each, "close-ups");
    const auto seed = static_cast<uint>(hash64(hash64(turn.seed + 107) + turn.index) >> 32);
    const Buffer<glm::vec2> steps(device, steps_about(each, film.count, turn), "steps of close-ups");
    kernels.get("close_ups")
        .args(close.pixels, static_cast<int>(pixels.size()), film.camera, film.offsets, film.count, steps, each, seed, scene.hierarchy(),
              scene.surfaces(), close.surfels.store())
        .run(kernels.packets(close.surfels.count), "close-ups");
    return close;
}

void average_close_ups(Kernels& kernels, const CloseUps& close_ups, const Buffer<int>& first_surfel, const Buffer<float>& values,
                       Buffer<float>& of_film, int film_capacity) {
    const int pixels = static_cast<int>(close_ups.pixels.size());
    kernels.get("average_close_ups")
        .args(close_ups.pixels, pixels, close_ups.samples, close_ups.each, first_surfel, values, close_ups.surfels.capacity, of_film,
              film_capacity)
        .run(static_cast<std::size_t>(pixels) * static_cast<std::size_t>(close_ups.samples), "average close-ups");
}

}  // namespace pencil
