// An image against its reference, layer by layer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/metrics.h"
#include "image/read_image.h"
#include "image/write_image.h"

namespace pencil {

struct LayerComparison {
    std::string name;
    std::vector<std::string> channels;
    Metrics metrics;
    NonFinite image, reference;  // what was excluded from the averages
};

struct Comparison {
    int width = 0, height = 0;
    double exposure = 1;                  // of displayed colours, see `exposure_of`
    std::vector<LayerComparison> layers;  // those that both images have, beauty first
    std::vector<std::string> only_in_image, only_in_reference;
    std::vector<std::string> warnings;  // another scene, unfinished image
};

/// Compares all common layers by the channels that both have. L*a*b* is measured for light (`is_light`), with the exposure of the
/// reference's beauty for all layers. SceneError if the sizes differ (naming both) or no layer is common; `image_name` and
/// `reference_name` are for messages.
Comparison compare_images(const Image& image, const Image& reference, const std::string& image_name, const std::string& reference_name);

}  // namespace pencil
