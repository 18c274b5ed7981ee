// Initial gathering with direct light, thesis algorithm 6.2, for the LightSample of kernels/shared/light.h, in double precision.
#pragma once

#include "reference/octahedral_ref.h"
#include "reference/visibility_ref.h"
#include "shared/types.h"
// The shared headers build on types.h.
#include "shared/light.h"

namespace pencil::ref {

inline dvec3 xyz(const float4& v) { return {v.x, v.y, v.z}; }

/// Irradiance at x from one light sample, visibility apart.
/// DEVIATION from alg. 6.2: 1/r^2 becomes 1/(r^2 + a/pi), a the area the sample stands for: the exact form factor of a disc of that area
/// seen on its axis. The printed form is unbounded at the light, and E_i there is a radiance times an area.
inline dvec3 sample_irradiance(const LightSample& light, const dvec3& x, const dvec3& normal) {
    const dvec3 to_light = xyz(light.position) - x;
    const double r2 = glm::dot(to_light, to_light), r = std::sqrt(r2);
    if (!(r > 0.0)) return dvec3(0.0);
    const double cos_x = std::max(glm::dot(normal, to_light) / r, 0.0);
    const bool area_light = light.position.w > 0.5F;
    const double cos_light = area_light ? std::max(-glm::dot(xyz(light.normal), to_light) / r, 0.0) : 1.0;
    const double area_over_pi = area_light ? static_cast<double>(light.normal.w) : 0.0;
    return xyz(light.emission) * (cos_x * cos_light / (r2 + area_over_pi));
}

struct DirectLight {
    dvec3 irradiance{0.0};
    double margin = 1.0;  // the smallest of the visibility margins of the samples that count
};

/// thesis alg. 6.2 without the BRDF: irradiance at x on plane `plane` with unit normal `normal`.
inline DirectLight direct_irradiance(const std::vector<LightSample>& lights, const std::vector<Triangle>& triangles, const dvec3& x,
                                     const dvec3& normal, int plane) {
    DirectLight out;
    for (const LightSample& light : lights) {
        const dvec3 e = sample_irradiance(light, x, normal);
        if (e == dvec3(0.0)) continue;
        const int emitter_plane = static_cast<int>(light.emission.w);
        const Visibility v = segment_visibility(triangles, x, xyz(light.position), {plane, emitter_plane});
        out.margin = std::min(out.margin, v.margin);
        if (v.visible) out.irradiance += e;
    }
    return out;
}

}  // namespace pencil::ref
