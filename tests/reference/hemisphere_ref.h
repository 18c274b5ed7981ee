// The map of a surface pencil and what is measured in it, in double precision.
#pragma once

#include <vector>

#include "reference/surface_pencil_ref.h"

namespace pencil::ref {

/// Texel of entry i of a hemisphere of n x n texels: through blocks of 4 x 4 row by row, in a block row by row.
inline Texel hemisphere_texel(int i, int n) {
    const int blocks_across = n / 4, block = i / 16, within = i % 16;
    return {block % blocks_across * 4 + within % 4, block / blocks_across * 4 + within / 4};
}

/// The point of the square [-1, 1]^2 that the concentric map (Shirley and Chiu 1997) takes to (x, y) of the unit disc.
inline dvec2 disc_to_square(double x, double y) {
    const double radius = std::hypot(x, y);
    if (radius == 0.0) return {0, 0};
    double angle = std::atan2(y, x);
    if (angle < -pi / 4) angle += 2 * pi;
    if (angle < pi / 4) return {radius, angle * radius * 4 / pi};
    if (angle < 3 * pi / 4) return {-(angle - pi / 2) * radius * 4 / pi, radius};
    if (angle < 5 * pi / 4) return {-radius, -(angle - pi) * radius * 4 / pi};
    return {(angle - 3 * pi / 2) * radius * 4 / pi, -radius};
}

/// What one texel sees; plane -1: nothing.
struct SeenTexel {
    dvec3 position, normal;  // geometric, towards the pencil
    int plane;
};

struct Measured {
    double harmonic = infinite;               // mean distance; texels that see nothing count as infinitely far
    double horizon_x[2 * RING_SECTORS] = {};  // as in SurfacePencil
    double horizon_y[2 * RING_SECTORS] = {};
};

/// Sector of a texel on the rim: that of its centre, corners nearer to the x axis.
inline int rim_sector(const Texel& texel, int n) { return ring_sector(2 * texel.x + 1 - n, (2 * texel.y + 1 - n) * (1 - 1e-9)); }

/// The nearest texel of `sector` on a plane other than `but`, -1: none.
inline int nearest_on_rim(const std::vector<SeenTexel>& seen, const dvec3& x, int n, int sector, int but) {
    int nearest = -1;
    for (int i = 0; i < n * n; ++i) {
        const Texel t = hemisphere_texel(i, n);
        const SeenTexel& s = seen[static_cast<std::size_t>(i)];
        const bool rim = t.x == 0 || t.y == 0 || t.x == n - 1 || t.y == n - 1;
        if (!rim || s.plane < 0 || s.plane == but || rim_sector(t, n) != sector) continue;
        if (nearest < 0 || glm::distance(s.position, x) < glm::distance(seen[static_cast<std::size_t>(nearest)].position, x)) nearest = i;
    }
    return nearest;
}

/// Harmonic mean distance, and for each sector of the rim the lines in which the two nearest planes cut the tangent plane: points p of it
/// are behind a plane through x + step with normal g where p . g / (step . g) >= 1.
inline Measured measure(const std::vector<SeenTexel>& seen, const dvec3& x, const dvec3& normal, int n) {
    Measured out;
    double inverse = 0;
    for (const SeenTexel& s : seen) inverse += s.plane >= 0 ? 1.0 / glm::distance(s.position, x) : 0.0;
    if (inverse > 0) out.harmonic = n * n / inverse;
    const TangentFrame frame(normal);
    for (int sector = 0; sector < RING_SECTORS; ++sector) {
        int but = -1;
        for (const int slot : {sector, sector + RING_SECTORS}) {
            const int i = nearest_on_rim(seen, x, n, sector, but);
            if (i < 0) break;
            const SeenTexel& s = seen[static_cast<std::size_t>(i)];
            const double towards = glm::dot(s.position - x, s.normal);
            out.horizon_x[slot] = glm::dot(s.normal, frame.t) / towards;
            out.horizon_y[slot] = glm::dot(s.normal, frame.b) / towards;
            but = s.plane;
        }
    }
    return out;
}

/// The share of an emitter's light at distance r that texels see; light samples, each standing for the area A, carry r^2 / (r^2 + A/pi).
inline double seen_share(double r, double area_over_pi) { return std::isinf(area_over_pi) ? 1.0 : 1.0 - r * r / (r * r + area_over_pi); }

}  // namespace pencil::ref
