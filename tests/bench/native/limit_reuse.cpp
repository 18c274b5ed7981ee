#include "bench/native/parallel.h"
#include "bench/native/surface.h"
#include "bench/native/surface_pencil.h"

namespace pencil::native {
namespace {

constexpr int reach = 2;

float limit(const LatticeView& film, int pixel, int spacing, float least) {
    const SurfacePencil& own = film.pencils[film.at[pixel]];
    const int column = pixel % film.width, row = pixel / film.width;
    for (int y = row - reach * spacing; y <= row + reach * spacing; y += spacing)
        for (int x = column - reach * spacing; x <= column + reach * spacing; x += spacing) {
            if (x < 0 || y < 0 || x >= film.width || y >= film.height || film.at[y * film.width + x] < 0) continue;
            const SurfacePencil& other = film.pencils[film.at[y * film.width + x]];
            const float distance = reuse_distance(other, xyz(own.position), xyz(own.normal));
            if (distance < infinite) least = std::min(least, other.emitters + distance);
        }
    return least;
}

}  // namespace

void limit_reuse(const LatticeView& film, int spacing, float* reaches) {
    parallel_blocks(
        film.width * film.height, 256,
        [&](int begin, int end) {
            for (int pixel = begin; pixel < end; ++pixel)
                if (film.at[pixel] >= 0) reaches[film.at[pixel]] = limit(film, pixel, spacing, film.pencils[film.at[pixel]].position.w);
        });
}

}  // namespace pencil::native
