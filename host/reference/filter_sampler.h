// Positions distributed as a reconstruction filter along one axis.
#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.h"

namespace pencil {

/// The filter as a table, linear within cells of 1/64 pixel.
class FilterSampler {
public:
    explicit FilterSampler(const ReconstructionFilter& filter);

    /// The part of the filter that is used.
    struct Range {
        double from = 0, to = 0;  // integral of |filter| up to its ends
        double scale = 0;         // to - from over the integral of the filter
    };
    /// Between `low` and `high`, odd multiples of half a pixel from the centre, low < 0 < high.
    Range range(double low, double high) const;

    struct Sample {
        double offset;  // from the pixel's centre [pixels]
        float weight;   // filter over density, relative to the filter's integral; negative in negative lobes
    };
    /// `u` in [0, 1).
    Sample sample(const Range& range, double u) const;

private:
    struct Cell {
        double start, width;  // [pixels]
        double from, to;      // integral of |filter| up to its ends
        double inverse;       // 1 / (to - from)
        double left, slope;   // filter over density: at the beginning, change over the cell
    };
    std::size_t cells_before(double x) const;

    double radius_ = 0;  // of the filter, rounded up to whole cells
    std::vector<Cell> cells_;
    std::vector<double> integral_;    // of the filter before each cell; one more than cells
    std::vector<std::size_t> guide_;  // for equal parts of the integral of |filter|: the first cell that reaches into the part
};

}  // namespace pencil
