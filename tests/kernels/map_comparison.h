// Geometry maps against a brute-force ray cast of every texel. No texel may differ except by a documented tie: a ray within rounding of
// an edge, two triangles within rounding of one depth, a plane within rounding of the centre.
#pragma once

#include "kernels/kernel_test.h"
#include "reference/tolerances.h"

namespace pencil::test {

/// Texels, those that differ (ties), and those that differ without a tie's excuse.
struct Comparison {
    int texels = 0, ties = 0, wrong = 0;
    std::string first_wrong;
};

/// Adds a texel that looks along `direction` to `out`; `where` names it.
inline void compare_texel(const TestScene& scene, const dvec3& centre, const dvec3& direction, const Hit& hit, const std::string& where,
                          Comparison& out) {
    const ref::RayHit truth = ref::nearest_triangle(scene.triangles, centre, direction);
    ++out.texels;
    std::string message;
    if (hit.triangle != truth.triangle) {
        ++out.ties;
        if (!ref::is_plausible(scene.triangles, centre, direction, hit.triangle)) message = "not a tie";
    }
    if (hit.triangle >= 0) {
        const ref::Crossing c = ref::cross_triangle(centre, direction, scene.triangles[static_cast<std::size_t>(hit.triangle)]);
        if (!(std::abs(hit.disparity * c.t - 1.0) <= tolerance::depth_tie * c.slant))
            message = "disparity, expected " + std::to_string(1.0 / c.t);
    } else if (hit.disparity != 0.0F) {
        message = "nothing is met, but the disparity is not 0";
    }
    if (message.empty() || out.wrong++ > 0) return;
    out.first_wrong = where + ": triangle " + std::to_string(hit.triangle) + " instead of " + std::to_string(truth.triangle) +
                      ", disparity " + std::to_string(hit.disparity) + ", margin " + std::to_string(truth.margin) + ": " + message;
}

/// Adds the texels of one octahedral tile to `out`.
inline void compare_tile(const TestScene& scene, const dvec3& centre, const std::vector<Hit>& hits, int tile, int n, Comparison& out) {
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            compare_texel(scene, centre, ref::texel_direction(x, y, n), hits[atlas_index(tile, x, y, n)],
                          "tile " + std::to_string(tile) + " texel " + std::to_string(x) + " " + std::to_string(y), out);
}

}  // namespace pencil::test
