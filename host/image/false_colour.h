// Values in false colours with the scale beside them, for what has a unit.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace pencil {

/// A picture for display: linear rgb, rows from the top.
struct Picture {
    int width = 0, height = 0;
    std::vector<float> rgb;
};

/// Display values (sRGB) from dark blue over green to pale yellow, ever lighter, so that it reads in grey, too. `position` in [0, 1].
std::array<float, 3> scale_colour(double position);

/// A round number, 1, 2 or 5 times a power of ten, that 99 % of the values do not exceed; 1 if none is above 0.
double scale_end(std::vector<float> values);

/// width x height values from 0 to scale_end in colours, more in its last one, NaN in red; at the right a legend with its numbers and `unit`.
Picture false_colours(const std::vector<float>& values, int width, int height, const std::string& unit);

}  // namespace pencil
