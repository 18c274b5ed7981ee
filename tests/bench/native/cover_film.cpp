#include "bench/native/parallel.h"
#include "bench/native/surface.h"
#include "bench/native/surface_pencil.h"

namespace pencil::native {

void cover_film(const LatticeView& film, float most_error, unsigned char* uncovered) {
    parallel_blocks(
        film.width * film.height, 256,
        [&](int begin, int end) {
            for (int pixel = begin; pixel < end; ++pixel)
                for (int i = film.first[pixel]; i < film.first[pixel] + (film.counts[pixel] & FILM_COUNT_MASK); ++i) {
                    const Vec3 x = vector_at(film.surfels, SURFEL_X, i), n = vector_at(film.surfels, SURFEL_NX, i);
                    float least = infinite;
                    visit_corners(
                        film, pixel % film.width, pixel / film.width,
                        [&](int p, int, int, int) {
                            if (least <= most_error) return;
                            const float distance = reuse_distance(film.pencils[p], x, n);
                            if (distance < infinite) least = std::min(least, reuse_error(film.pencils[p], distance, n));
                        });
                    uncovered[i] = least > most_error ? 1 : 0;
                }
        });
}

}  // namespace pencil::native
