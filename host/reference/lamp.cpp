#include "reference/lamp.h"

#include <algorithm>
#include <cmath>

#include "util/constants.h"

namespace pencil {
namespace {

/// Linear in the angle between beam and cutoff (Mitsuba's spot).
double spot_factor(const PointLight& light, double angle) {
    if (angle >= light.cutoff) return 0;
    if (angle <= light.beam_width) return 1;
    return (light.cutoff - angle) / (light.cutoff - light.beam_width);
}

struct Place {
    std::size_t index = 0, next = 0;
    double share = 0;
};

Place place_in(const std::vector<float>& angles, double angle) {
    const auto after = static_cast<std::size_t>(std::upper_bound(angles.begin(), angles.end(), angle) - angles.begin());
    if (after == 0) return {};
    if (after == angles.size()) return {after - 1, after - 1, 0};
    const double low = angles[after - 1], high = angles[after];
    return {after - 1, after, (angle - low) / (high - low)};
}

/// Between the angles of the table; dark where it has no vertical angle.
double profile_factor(const LightProfile& profile, double angle, double azimuth) {
    if (profile.vertical.empty() || angle > static_cast<double>(profile.vertical.back()) ||
        angle < static_cast<double>(profile.vertical.front()))
        return 0;
    const Place v = place_in(profile.vertical, angle), h = place_in(profile.horizontal, azimuth);
    const auto column = [&](std::size_t k) {
        const float* values = profile.values.data() + k * profile.vertical.size();
        return (1 - v.share) * static_cast<double>(values[v.index]) + v.share * static_cast<double>(values[v.next]);
    };
    return (1 - h.share) * column(h.index) + h.share * column(h.next);
}

}  // namespace

double lamp_factor(const PointLight& light, const std::vector<LightProfile>& profiles, const glm::dvec3& direction) {
    if (!light.is_spot && light.profile < 0) return 1;
    const double angle = glm::degrees(std::acos(std::clamp(direction.z, -1.0, 1.0)));
    double factor = light.is_spot ? spot_factor(light, angle) : 1;
    if (light.profile < 0) return factor;
    const double azimuth = glm::degrees(std::atan2(direction.y, direction.x));
    return factor * profile_factor(profiles[static_cast<std::size_t>(light.profile)], angle, azimuth < 0 ? azimuth + 360 : azimuth);
}

double lamp_extent(const PointLight& light, const std::vector<LightProfile>& profiles) {
    constexpr int steps = 256, turns = 16;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int k = 0; k < turns; ++k) {
            const double theta = (i + 0.5) * pi / steps, phi = 2 * pi * (k + 0.5) / turns, sine = std::sin(theta);
            sum += sine * lamp_factor(light, profiles, {sine * std::cos(phi), sine * std::sin(phi), std::cos(theta)});
        }
    return sum * (pi / steps) * (2 * pi / turns);
}

}  // namespace pencil
