#include "pencils/profile_table.h"

#include <algorithm>
#include <glm/glm.hpp>
#include <glm/gtc/packing.hpp>

#include "shared/light.h"

namespace pencil {

namespace {

/// Linear between the angles of a table, from `values` of each, the last value beyond them.
double between(const std::vector<float>& angles, const float* values, double angle) {
    const auto after = static_cast<std::size_t>(std::upper_bound(angles.begin(), angles.end(), angle) - angles.begin());
    if (after == 0) return static_cast<double>(values[0]);
    if (after == angles.size()) return static_cast<double>(values[after - 1]);
    const double low = angles[after - 1], high = angles[after], share = (angle - low) / (high - low);
    return (1 - share) * static_cast<double>(values[after - 1]) + share * static_cast<double>(values[after]);
}

double value_at(const LightProfile& profile, double angle, double azimuth) {
    constexpr double slack = 1e-3;  // [degrees]
    if (profile.vertical.empty() || angle > static_cast<double>(profile.vertical.back()) + slack ||
        angle < static_cast<double>(profile.vertical.front()) - slack)
        return 0;
    std::vector<float> columns;
    for (std::size_t k = 0; k < profile.horizontal.size(); ++k)
        columns.push_back(static_cast<float>(between(profile.vertical, profile.values.data() + k * profile.vertical.size(), angle)));
    return between(profile.horizontal, columns.data(), azimuth);
}

}  // namespace

int add_profile_table(const PointLight& light, const LightProfile& profile, std::vector<std::uint64_t>& texels) {
    const auto first = static_cast<int>(texels.size());
    texels.push_back(glm::packHalf4x16(glm::vec4(glm::vec3(glm::normalize(glm::dvec3(light.to_world[0]))), 0.0F)));
    for (int column = 0; column < PROFILE_COLUMNS; ++column)
        for (int row = 0; row < PROFILE_ROWS; ++row)
            texels.push_back(glm::packHalf4x16(
                glm::vec4(static_cast<float>(value_at(profile, 180.0 * row / (PROFILE_ROWS - 1), 360.0 * column / PROFILE_COLUMNS)))));
    return first;
}

}  // namespace pencil
