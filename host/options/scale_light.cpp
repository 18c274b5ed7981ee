#include "options/scale_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pencil {

namespace {

/// Values that float could not hold.
struct OutOfRange {
    std::uint64_t large = 0;
    std::uint64_t small = 0;  // not 0, but below the smallest normal number
};

OutOfRange scale(double unit, std::vector<float>& values) {
    constexpr auto most = static_cast<double>(std::numeric_limits<float>::max()),
                   least = static_cast<double>(std::numeric_limits<float>::min());
    OutOfRange found;
    for (float& value : values) {
        if (!std::isfinite(value) || value == 0.0F) continue;
        const double scaled = static_cast<double>(value) * unit, size = std::abs(scaled);
        found.large += size > most ? 1 : 0;
        found.small += size < least ? 1 : 0;
        value = static_cast<float>(std::clamp(scaled, -most, most));
    }
    return found;
}

void add_warnings(const OutOfRange& found, const std::string& layer, std::vector<std::string>& warnings) {
    const std::string name = layer.empty() ? "the image" : "layer " + layer;
    if (found.large > 0)
        warnings.push_back(fmt::format(
            "{} values of {} are too large for float and became its largest number; dim all lights by one factor", found.large, name));
    if (found.small > 0)
        warnings.push_back(fmt::format(
            "{} values of {} are too small for float and are rounded, some to 0; brighten all lights by one factor", found.small, name));
}

}  // namespace

std::vector<std::string> scale_light(double unit, std::vector<Layer>& layers) {
    std::vector<std::string> warnings;
    if (unit == 1.0) return warnings;
    for (Layer& layer : layers) {
        if (has_group(surface_groups(), layer.name)) continue;
        add_warnings(scale(layer.name == variance_layer ? unit * unit : unit, layer.pixels), layer.name, warnings);
    }
    return warnings;
}

}  // namespace pencil
