// Sampling rates of a parameterisation (thesis table 6.6, figure 6.9), from the exact solid angles of a fine grid of texels.
#pragma once

#include <vector>

#include "reference/map_ref.h"

namespace pencil::thesis {

/// The sampling rate is texel area per solid angle, relative to its mean over the sphere: 1 everywhere would be ideal. Texels that the
/// map's covered part only touches do not enter.
struct SamplingRates {
    double used = 0;                // share of the texels' area that holds directions of its own
    double ratio = 0;               // largest over smallest rate
    double variation_sphere = 0;    // standard deviation over mean of the rate, directions weighted by solid angle
    double variation_texels = 0;    // the same, each texel weighted alike
    double deviation = 0;           // mean |rate - 1| over the sphere
    std::vector<double> histogram;  // share of the sphere in bins of width bin_width of the relative rate, from 0
    static constexpr double bin_width = 0.05, most = 5.0;
};

SamplingRates sampling_rates(const ref::Map& map, int n);

}  // namespace pencil::thesis
