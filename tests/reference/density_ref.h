// Directional pencil density (DPDF), thesis eq. (5.32) and algorithm 6.1, at one surface point, in double precision.
#pragma once

#include <cmath>
#include <vector>

#include "reference/octahedral_ref.h"

namespace pencil::ref {

/// Exponent of the cosine lobes for n_v visible pencils: the power of two nearest to 5 n_v^(1/3) (in the logarithm), from 1 to 512.
/// Not the thesis', which makes beta_j proportional to the mean distance of centres or sets it by hand: cos^beta is a kernel of angular
/// width h ~ beta^(-1/2), and the width that balances bias and variance of a density estimate from n directions on the sphere falls as
/// n^(-1/6) (Hall, Watson and Cabrera 1987), so beta ~ n^(1/3). Lobes as wide as the spacing of directions, h ~ n^(-1/2), would count
/// hardly more than themselves.
inline double lobe_exponent(int visible_pencils) {
    if (visible_pencils <= 0) return 1.0;
    const double exponent = std::round(std::log2(5.0 * std::cbrt(static_cast<double>(visible_pencils))));
    return std::exp2(std::min(std::max(exponent, 0.0), 9.0));
}

/// thesis eq. (5.32): D_i = sum_j V_j cos_+^beta(theta_ij), theta_ij the angle at x between the directions to pencils i and j.
/// `directions`: unit directions from x to the pencils; hidden ones neither count nor get a density (0).
inline std::vector<double> pencil_density(const std::vector<dvec3>& directions, const std::vector<bool>& visible, double beta) {
    std::vector<double> density(directions.size(), 0.0);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        if (!visible[i]) continue;
        for (std::size_t j = 0; j < directions.size(); ++j)
            if (visible[j]) density[i] += std::pow(std::max(glm::dot(directions[i], directions[j]), 0.0), beta);
    }
    return density;
}

}  // namespace pencil::ref
