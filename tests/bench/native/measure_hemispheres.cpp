#include "bench/native/parallel.h"
#include "bench/native/surface.h"
#include "bench/native/surface_pencil.h"

namespace pencil::native {
namespace {

constexpr float tiny = 0.1F;  // of the rounding of positions

struct Nearest {
    float distance = infinite;
    int texel = 0, plane = -1;
};

/// Keeps the nearest plane of a sector, and the nearest of the others.
inline void keep(Nearest& first, Nearest& second, const Nearest& seen) {
    if (seen.plane == first.plane) {
        if (seen.distance < first.distance) first = seen;
    } else if (seen.distance < first.distance) {
        second = first;
        first = seen;
    } else if (seen.distance < second.distance) {
        second = seen;
    }
}

void measure(const SurfelsView& surfels, int first, int n, SurfacePencil& pencil) {
    const Vec3 at = xyz(pencil.position);
    Nearest nearest[2 * RING_SECTORS];
    float inverse = 0.0F;
    for (int i = 0; i < n * n; ++i) {
        const int plane = int_at(surfels, SURFEL_PLANE, first + i);
        if (plane < 0) continue;
        const Vec3 step = vector_at(surfels, SURFEL_X, first + i) - at;
        const float distance = std::sqrt(dot(step, step));
        inverse += 1.0F / std::max(distance, tiny * position_error(at));
        const int x = texel_x(i, n), y = texel_y(i, n);
        if (x > 0 && x < n - 1 && y > 0 && y < n - 1) continue;
        const int sector = ring_sector(static_cast<float>(2 * x + 1 - n), static_cast<float>(2 * y + 1 - n));
        keep(nearest[sector], nearest[sector + RING_SECTORS], {distance, first + i, plane});
    }
    pencil.position.w = inverse > 0.0F ? static_cast<float>(n * n) / inverse : infinite;
    Vec3 t, b;
    tangent_frame(xyz(pencil.normal), t, b);
    for (int s = 0; s < 2 * RING_SECTORS; ++s) {
        pencil.horizon_x[s] = pencil.horizon_y[s] = 0.0F;
        if (nearest[s].plane < 0) continue;
        const Vec3 g = vector_at(surfels, SURFEL_GX, nearest[s].texel);
        const float towards = std::min(dot(vector_at(surfels, SURFEL_X, nearest[s].texel) - at, g), -tiny * position_error(at));
        pencil.horizon_x[s] = dot(g, t) / towards;
        pencil.horizon_y[s] = dot(g, b) / towards;
    }
}

}  // namespace

void measure_hemispheres(const SurfelsView& surfels, int count, int n, SurfacePencil* pencils) {
    parallel_blocks(
        count, 16,
        [&](int first, int last) {
            for (int p = first; p < last; ++p) measure(surfels, p * n * n, n, pencils[p]);
        });
}

}  // namespace pencil::native
