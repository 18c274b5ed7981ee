#include "bench/native/parallel.h"
#include "bench/native/surface.h"
#include "bench/native/surface_pencil.h"

namespace pencil::native {
namespace {

constexpr int smooth_reach = 3;
constexpr float slope_hold = 1e-3F;

/// Sums of weights, of (s, u) and the irradiance, and of their products.
struct LineSums {
    float w = 0, ws = 0, wu = 0, wss = 0, wsu = 0, wuu = 0;
    float4v e{}, es{}, eu{};

    void add(float weight, float s, float u, float4v irradiance) {
        w += weight;
        ws += weight * s;
        wu += weight * u;
        wss += weight * s * s;
        wsu += weight * s * u;
        wuu += weight * u * u;
        e += weight * irradiance;
        es += weight * s * irradiance;
        eu += weight * u * irradiance;
    }
    /// s and u are in terms of `unit`.
    void solve(float tiny, float unit, float4* fit) const {
        const float ms = ws / w, mu = wu / w;
        float ss = wss - ms * ws, uu = wuu - mu * wu;
        const float su = wsu - ms * wu, hold = slope_hold * (ss + uu) + w * tiny * tiny;
        ss += hold;
        uu += hold;
        const float determinant = ss * uu - su * su;
        const float4v cs = es - ms * e, cu = eu - mu * e, t = (uu * cs - su * cu) / determinant, b = (ss * cu - su * cs) / determinant;
        const float4v value = e / w - ms * t - mu * b, zero{};
        store(value > zero ? value : zero, fit);
        store(t / unit, fit + 1);
        store(b / unit, fit + 2);
    }
};

}  // namespace

void smooth_irradiance(const LatticeView& film, const float4* irradiance, float most_error, float4* fits) {
    parallel_blocks(
        film.width * film.height, 256,
        [&](int first, int last) {
            for (int pixel = first; pixel < last; ++pixel) {
                const int index = film.at[pixel];
                if (index < 0) continue;
                const SurfacePencil& own = film.pencils[index];
                const Vec3 x = xyz(own.position), n = xyz(own.normal);
                Vec3 t, b;
                tangent_frame(n, t, b);
                const float unit = own.facing.w;
                LineSums sums;
                visit_neighbours(
                    film, pixel % film.width, pixel / film.width, smooth_reach, own.spacing,
                    [&](int other) {
                        const SurfacePencil& p = film.pencils[other];
                        const float distance = reuse_distance(p, x, n);
                        if (distance == infinite) return;
                        const float error = reuse_error(p, distance, n) + reuse_error(own, distance, n);
                        const Vec3 step = xyz(p.position) - x;
                        sums.add(std::max(1.0F - error / (2.0F * most_error), 0.0F), dot(step, t) / unit, dot(step, b) / unit,
                                 load4(irradiance[other]));
                    });
                sums.solve(std::max(position_error(x) / unit, 1e-6F), unit, fits + 3 * static_cast<std::size_t>(index));
            }
        });
}

}  // namespace pencil::native
