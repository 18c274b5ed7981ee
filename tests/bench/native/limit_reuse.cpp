#include "bench/native/parallel.h"
#include "bench/native/surface.h"
#include "bench/native/surface_pencil.h"

namespace pencil::native {
namespace {

constexpr int reach = 2;
constexpr float times = 4;

float limit(const LatticeView& film, int pixel, int spacing, float least) {
    const SurfacePencil& own = film.pencils[film.at[pixel]];
    visit_neighbours(film, pixel % film.width, pixel / film.width, reach, spacing, [&](int index) {
        const SurfacePencil& other = film.pencils[index];
        const float distance = reuse_distance(other, xyz(own.position), xyz(own.normal));
        if (distance < infinite) least = std::min(least, std::min(other.emitters, times * other.position.w) + distance);
    });
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
