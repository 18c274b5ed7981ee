#include "bench/native/parallel.h"
#include "bench/native/surface.h"
#include "bench/native/surface_pencil.h"

namespace pencil::native {
namespace {

inline float4v positive(float4v v) {
    const float4v zero{};
    return v > zero ? v : zero;
}

/// What the fits about pixel (px, py) say at x.
inline float4v irradiance_at(const LatticeView& film, const float4* fits, float most_error, int px, int py, const Vec3& x, const Vec3& n) {
    float4v sum{}, last{};
    float weights = 0.0F, least = infinite;
    visit_corners(film, px, py, [&](int index, int cx, int cy, int spacing) {
        const SurfacePencil& p = film.pencils[index];
        const float4* fit = fits + 3 * static_cast<std::size_t>(index);
        const float distance = reuse_distance(p, x, n);
        const float error = distance < infinite ? std::max(reuse_error(p, distance, n), 0.02F * most_error) : infinite;
        const float scale = 1.0F / static_cast<float>(spacing);
        const float tent = std::max(1.0F - static_cast<float>(std::abs(cx - px)) * scale, 0.0F) *
                           std::max(1.0F - static_cast<float>(std::abs(cy - py)) * scale, 0.0F);
        const float weight = std::max(1.0F / error - 1.0F / most_error, 0.0F) * tent;
        const Vec3 step = x - xyz(p.position);
        if (weight > 0.0F) {
            Vec3 t, b;
            tangent_frame(xyz(p.normal), t, b);
            sum += weight * positive(load4(fit[0]) + dot(step, t) * load4(fit[1]) + dot(step, b) * load4(fit[2]));
            weights += weight;
        }
        const float unlike = dot(step, step) + (1.0F - dot(xyz(p.normal), n)) * 0.25F * dot(x, x);
        if (unlike < least) {
            least = unlike;
            last = load4(fit[0]);
        }
    });
    return weights > 0.0F ? sum / weights : last;
}

}  // namespace

void project_film_pencils(const LatticeView& film, const float4* fits, float most_error, const float4* single_irradiance,
                          const int* single_at, RgbView outgoing) {
    constexpr float inverse_pi = 0.318309886F;
    parallel_blocks(film.width * film.height, 256, [&](int begin, int end) {
        for (int pixel = begin; pixel < end; ++pixel)
            for (int i = film.first[pixel]; i < film.first[pixel] + (film.counts[pixel] & FILM_COUNT_MASK); ++i) {
                const float4v e = single_at[i] >= 0
                                      ? load4(single_irradiance[single_at[i]])
                                      : irradiance_at(film, fits, most_error, pixel % film.width, pixel / film.width,
                                                      vector_at(film.surfels, SURFEL_X, i), vector_at(film.surfels, SURFEL_NX, i));
                for (int c = 0; c < 3; ++c) outgoing.channel(c)[i] += film.surfels.field(SURFEL_ALBEDO_R + c)[i] * e[c] * inverse_pi;
            }
    });
}

}  // namespace pencil::native
