// Positions distributed as a reconstruction filter along one axis.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace pencil {

class FilterSampler {
public:
    explicit FilterSampler(const ReconstructionFilter& filter);

    struct Sample {
        double offset;  // from the pixel's centre [pixels]
        float weight;   // filter over density, relative to the filter's integral; negative in negative lobes
    };
    /// The filter restricted to [low, high] around the centre, both odd multiples of half a pixel, low < 0 < high; `u` in [0, 1).
    Sample sample(double u, double low, double high) const;

private:
    double at(const std::vector<double>& running, double x) const;

    ReconstructionFilter filter_;
    double radius_ = 0;              // of the table, a multiple of the cell width
    std::vector<double> density_;    // per cell: mean of |filter|
    std::vector<double> magnitude_;  // running integral of |filter|, one more than cells
    std::vector<double> integral_;   // running integral of the filter
};

}  // namespace pencil
