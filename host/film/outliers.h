// Light that came by one path of millions: a pixel that one of a few independent images shows far above the others. It is true in the mean over
// all pixels that such paths may come to, and wrong where it lies: it is spread there, within the noise that they have.
#pragma once

#include <vector>

namespace pencil {

/// One of several images of the same pixels, rgb.
using ImageValues = std::vector<float>;

struct SpreadOutliers {
    std::vector<ImageValues> steps;  // to be added to each image
    std::vector<float> limits;       // of what outliers show in all their channels together, for each pixel; the others have none: infinite
};

/// Spreads what only one of the independent `images`, three or more of this width, shows of a pixel, over a window about it: as wide as needed for
/// each pixel's part to be small beside its noise. Pixels that are known get nothing. The sum of every image stays as it is.
SpreadOutliers spread_outliers(const std::vector<ImageValues>& images, int width);

}  // namespace pencil
