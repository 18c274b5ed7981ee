// One pencil transport to a surface point, thesis eq. (5.23) and algorithm 6.3, in double precision: irradiance from the radiance that
// the visible pencils carry along their lines to the point. A diffuse surface then radiates albedo / pi times it.
#pragma once

#include <vector>

#include "reference/octahedral_ref.h"

namespace pencil::ref {

/// What a surface point knows of one pencil.
struct PencilView {
    dvec3 radiance{0.0};   // L(c_i, w_i): radiance at the pencil from the direction opposite to the point
    double cosine = 0.0;   // between the point's normal and the direction to the pencil; not in front: does not count
    double density = 0.0;  // D_i, thesis eq. (5.32)
    bool visible = false;
};

inline bool counts(const PencilView& view) { return view.visible && view.cosine > 0.0 && view.density > 0.0; }

/// DEVIATION: the consistent self-normalised weights, w_i cos_i = pi (cos_i/D_i) / sum_j (cos_j/D_j). The normaliser of eq. (5.33) and
/// alg. 6.3 does not tend to the integral, see `irradiance_printed`. Exact for constant radiance whatever D is.
inline dvec3 irradiance_consistent(const std::vector<PencilView>& views) {
    dvec3 sum(0.0);
    double weights = 0.0;
    for (const PencilView& view : views) {
        if (!counts(view)) continue;
        sum += view.radiance * (view.cosine / view.density);
        weights += view.cosine / view.density;
    }
    return weights > 0.0 ? sum * (pi / weights) : dvec3(0.0);
}

/// As printed: alg. 6.3 multiplies sum_i L_i cos_i / D_i by sum_j D_j (the normaliser of eq. 5.33). The mean of n_v samples over the
/// hemisphere's 2 pi, with the density relative to its mean: E = (2 pi / n_v^2) sum_j D_j sum_i L_i cos_i / D_i.
inline dvec3 irradiance_printed(const std::vector<PencilView>& views) {
    dvec3 sum(0.0);
    double densities = 0.0, count = 0.0;
    for (const PencilView& view : views) {
        if (!counts(view)) continue;
        sum += view.radiance * (view.cosine / view.density);
        densities += view.density;
        count += 1.0;
    }
    return count > 0.0 ? sum * (2.0 * pi * densities / (count * count)) : dvec3(0.0);
}

/// Diffuse BRDF f_r = albedo / pi.
inline dvec3 scattered_radiance(const dvec3& albedo, const dvec3& irradiance) { return albedo * irradiance / pi; }

}  // namespace pencil::ref
