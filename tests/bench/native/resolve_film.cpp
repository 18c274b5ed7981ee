#include "bench/native/native.h"
#include "bench/native/parallel.h"
#include "shared/film.h"

namespace pencil::native {
namespace {

/// Adds the samples of one neighbour, weighted by the filter.
inline void add_neighbour(const FilmView& film, const float* values, std::size_t capacity, int pixel, int cell, float* sum) {
    const float* v = values + film.first_surfel[pixel];
    if (film.counts[pixel] == 1) {
        for (int c = 0; c < 3; ++c) sum[c] += film.totals[cell] * v[static_cast<std::size_t>(c) * capacity];
        return;
    }
    const unsigned char* slots = film.slots + static_cast<std::size_t>(pixel) * static_cast<std::size_t>(film.samples);
    const float* weights = film.weights + cell * film.samples;
    for (int s = 0; s < film.samples; ++s) {
        if (slots[s] == NO_SURFEL) continue;
        for (int c = 0; c < 3; ++c) sum[c] += weights[s] * v[static_cast<std::size_t>(c) * capacity + slots[s]];
    }
}

}  // namespace

void resolve_film(const FilmView& film, const float* values, std::size_t capacity, float* image) {
    parallel_blocks(
        film.height, 4,
        [&](int top, int bottom) {
            for (int y = top; y < bottom; ++y)
                for (int x = 0; x < film.width; ++x) {
                    float sum[3] = {}, norm = 0.0F;
                    for (int qy = std::max(y - film.reach, 0); qy <= std::min(y + film.reach, film.height - 1); ++qy)
                        for (int qx = std::max(x - film.reach, 0); qx <= std::min(x + film.reach, film.width - 1); ++qx) {
                            const int cell = (qy - y + film.reach) * (2 * film.reach + 1) + qx - x + film.reach;
                            norm += film.totals[cell];
                            add_neighbour(film, values, capacity, qy * film.width + qx, cell, sum);
                        }
                    float* pixel =
                        image + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) + static_cast<std::size_t>(x));
                    for (int c = 0; c < 3; ++c) pixel[c] = norm > 0.0F ? sum[c] / norm : 0.0F;
                }
        });
}

}  // namespace pencil::native
