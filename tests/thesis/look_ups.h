// Thesis 6.3.1: 128 map look-ups per pixel of the Cornell box, for each parameterisation, on the same surfels and the same light.
#pragma once

#include <vector>

#include "reference/all_maps.h"
#include "thesis/lit_pencils.h"

namespace pencil::thesis {

struct LookUpTimes {
    int n = 0;                              // texels along a side of a tile
    std::vector<double> seconds;            // device time of each launch: look-ups with bilinear reads
    std::vector<double> footprint_seconds;  // the same without reading texels: the map's arithmetic
    double difference = 0;                  // mean |sum - sum of the first map| / mean sum of the first map
    double reference_difference = 0;        // |sum - double precision sum| / mean sum, which 90 % of the checked surfels stay below
};

/// Looks up every map `options.repeats` times, in rounds over all maps, so that what else the machine does meets them alike. A map that
/// has taken most_seconds sits the other rounds out. In the order of `maps`.
std::vector<LookUpTimes> time_look_ups(LitPencils& pencils, const std::vector<ref::NamedMap>& maps, int texels, int repeats);

constexpr double most_seconds = 6.0;

}  // namespace pencil::thesis
