#include "pencils/flat_sky.h"

#include <algorithm>
#include <cmath>

#include "image/colour.h"
#include "pencils/low_discrepancy.h"
#include "scene/light_unit.h"
#include "util/constants.h"

namespace pencil {

namespace {

/// Texels brighter than so many times the mean are lights, as far as they exceed it: hemispheres of few rays find the rest well.
constexpr double bright = 4;

/// Angle to the pole at the upper edge of a row: the first and last rows are centred on the poles (Mitsuba).
double edge(const Sky& sky, int row) { return sky.height > 1 ? std::clamp((row - 0.5) / (sky.height - 1), 0.0, 1.0) * pi : row * pi; }

/// Solid angle of a texel of row `y` [sr].
double texel_angle(const Sky& sky, int y) { return 2 * pi / sky.width * (std::cos(edge(sky, y)) - std::cos(edge(sky, y + 1))); }

double above(const Sky& sky, const float4& texel) { return std::max(luminance(glm::dvec3(texel)) - static_cast<double>(sky.limit), 0.0); }

/// World direction at a column [texels] and an angle to the pole.
glm::vec3 direction_of(const Sky& sky, double x, double theta) {
    const double phi = 2 * pi * x / sky.width;
    const glm::dvec3 local(std::sin(phi) * std::sin(theta), std::cos(theta), -std::cos(phi) * std::sin(theta));
    return glm::vec3(local.x * glm::dvec3(sky.to_local[0]) + local.y * glm::dvec3(sky.to_local[1]) + local.z * glm::dvec3(sky.to_local[2]));
}

}  // namespace

Sky flatten_sky(const Scene& scene, std::vector<float4>& texels, double light) {
    Sky sky{};
    if (!scene.environment) return sky;
    const Environment& e = *scene.environment;
    sky.width = e.is_map() ? e.width : 1;
    sky.height = e.is_map() ? e.height : 1;
    const auto add = [&](const glm::dvec3& radiance) { texels.emplace_back(in_light_unit(radiance, light), 0.0F); };
    if (e.is_map())
        for (const glm::vec3& texel : e.texels) add(glm::dvec3(e.radiance) * glm::dvec3(texel));
    else
        add(e.radiance);
    for (int k = 0; k < 3; ++k) sky.to_local[k] = float4(glm::vec3(glm::normalize(e.to_world[k])), 0.0F);
    double sum = 0;
    for (std::size_t i = 0; i < texels.size(); ++i)
        sum += luminance(glm::dvec3(texels[i])) * texel_angle(sky, static_cast<int>(i) / sky.width);
    sky.limit = static_cast<float>(bright * sum / (4 * pi));
    const double power = sampled_sky_power(sky, texels);
    sky.each_sample = power > 0 ? static_cast<float>(1 / power) : 0.0F;
    return sky;
}

double sampled_texel_power(const Sky& sky, const std::vector<float4>& texels, std::size_t texel) {
    return above(sky, texels[texel]) * texel_angle(sky, static_cast<int>(texel) / sky.width);
}

double sampled_sky_power(const Sky& sky, const std::vector<float4>& texels) {
    double sum = 0;
    for (std::size_t i = 0; i < texels.size(); ++i) sum += above(sky, texels[i]) * texel_angle(sky, static_cast<int>(i) / sky.width);
    return sum;
}

void sample_sky(const Sky& sky, const std::vector<float4>& texels, int count, std::uint64_t seed, std::uint64_t turn,
                std::vector<LightSample>& samples) {
    const double total = sampled_sky_power(sky, texels);
    if (!(total > 0) || count <= 0) return;
    const double start = fraction(random_unit(seed, 3, 0) + static_cast<double>(turn) * golden_ratio), step = total / count;
    double sum = 0, next = start * step;
    std::uint64_t drawn = turn * static_cast<std::uint64_t>(count);
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const int y = static_cast<int>(i) / sky.width, x = static_cast<int>(i) % sky.width;
        const double over = above(sky, texels[i]), power = over * texel_angle(sky, y);
        for (sum += power; next < sum; next += step, ++drawn) {
            const glm::dvec2 u = r2_sequence(drawn, glm::dvec2(random_unit(seed, 4, 0), random_unit(seed, 5, 0)));
            // Uniform in solid angle within the texel.
            const double low = std::cos(edge(sky, y + 1)), high = std::cos(edge(sky, y));
            const double theta = std::acos(low + u.y * (high - low));
            LightSample s{};
            s.position = float4(-direction_of(sky, x + u.x, theta), LIGHT_INFINITE);
            const double share = over / luminance(glm::dvec3(texels[i]));  // of its radiance that is sampled
            const double angle = step / over;                              // that the sample stands for [sr]
            s.normal = float4(0.0F, 0.0F, 0.0F, static_cast<float>(angle));
            s.emission = float4(glm::vec3(glm::dvec3(texels[i]) * (share * angle)), -1.0F);
            samples.push_back(s);
        }
    }
}

}  // namespace pencil
