#include "surface/spots.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pencil {

namespace {

// Found by trial (docs/accuracy.md).

/// What sends so many times the mean is bright.
constexpr double bright = 6;
/// Spots are worth their rays where this share of the light comes from what is bright,
constexpr double least_light = 0.3;
/// so little is, of what is seen,
constexpr double most_seen = 0.03;
/// and enough of it that it is no chance.
constexpr std::size_t least_points = 8;
/// What is emitted counts where it is this share of what spots send.
constexpr float least_emission = 0.05F;
/// Radius of a spot in terms of the root mean square distance of its points, and of their reach at least.
constexpr float spread = 1.5F, least_radius = 0.25F;

struct SpotCluster {
    glm::dvec3 sum{0};
    double squares = 0, light = 0;
    glm::vec3 first{0};

    void add(const glm::vec3& p, double l) {
        const glm::dvec3 step = glm::dvec3(p) - glm::dvec3(first);
        sum += l * step;
        squares += l * glm::dot(step, step);
        light += l;
    }
    Spot spot(float reach, double all) const {
        const glm::dvec3 middle = sum / light;
        const double variance = std::max(squares / light - glm::dot(middle, middle), 0.0);
        return {first + glm::vec3(middle), std::max(spread * static_cast<float>(std::sqrt(variance)), least_radius * reach),
                static_cast<float>(light / all)};
    }
};

/// Numbers of the bright points, the brightest first; empty if they are not worth it.
std::vector<std::size_t> bright_points(const std::vector<float>& light) {
    const double all = std::accumulate(light.begin(), light.end(), 0.0), mean = all / static_cast<double>(light.size());
    std::vector<std::size_t> points;
    double of_bright = 0;
    for (std::size_t i = 0; i < light.size(); ++i) {
        if (!(static_cast<double>(light[i]) > bright * mean)) continue;
        points.push_back(i);
        of_bright += static_cast<double>(light[i]);
    }
    if (points.size() < least_points || of_bright < least_light * all ||
        static_cast<double>(points.size()) > most_seen * static_cast<double>(light.size()))
        return {};
    std::stable_sort(points.begin(), points.end(), [&](std::size_t a, std::size_t b) { return light[a] > light[b]; });
    return points;
}

}  // namespace

std::vector<Spot> find_spots(const std::vector<glm::vec3>& points, const std::vector<float>& light, float reach) {
    std::vector<SpotCluster> clusters;
    for (const std::size_t i : bright_points(light)) {
        const auto near = std::find_if(clusters.begin(), clusters.end(),
                                       [&](const SpotCluster& c) { return glm::distance(c.first, points[i]) <= reach; });
        if (near != clusters.end())
            near->add(points[i], static_cast<double>(light[i]));
        else if (clusters.size() < SPOTS_MOST) {
            clusters.emplace_back();
            clusters.back().first = points[i];
            clusters.back().add(points[i], static_cast<double>(light[i]));
        }
    }
    const double all = std::accumulate(light.begin(), light.end(), 0.0);
    std::vector<Spot> spots;
    for (const SpotCluster& cluster : clusters) spots.push_back(cluster.spot(reach, all));
    return spots;
}

DeviceSpots::DeviceSpots(const std::shared_ptr<Device>& device, const std::vector<Spot>& spots)
    : count(std::min(static_cast<int>(spots.size()), SPOTS_MOST)), found(spots) {
    if (found.empty()) return;
    std::stable_sort(found.begin(), found.end(), [](const Spot& a, const Spot& b) { return a.weight > b.weight; });
    found.resize(static_cast<std::size_t>(count));
    std::vector<float4> places;
    std::vector<float> of_each;
    for (const Spot& spot : found) {
        places.emplace_back(spot.centre, spot.radius);
        of_each.push_back(spot.weight);
    }
    spheres = Buffer<float4>(device, places, "bright spots");
    weights = Buffer<float>(device, of_each, "weights of bright spots");
}

bool DeviceSpots::shine() const {
    float all = 0, emission = 0;
    for (const Spot& spot : found) {
        all += spot.weight;
        emission += spot.weight * spot.emission;
    }
    return emission > least_emission * all;
}

std::vector<Spot> find_spots(const Surfels& surfels, const Buffer<float>& radiance, float reach) {
    const auto count = static_cast<std::size_t>(surfels.count), capacity = static_cast<std::size_t>(surfels.capacity);
    const std::vector<float> x = surfels.data.read_rows(0, capacity, SURFEL_Z + 1, count);
    std::vector<glm::vec3> points(count);
    for (std::size_t i = 0; i < count; ++i) points[i] = {x[i], x[count + i], x[2 * count + i]};
    return find_spots(points, light_of(surfels, radiance), reach);
}

std::vector<float> light_of(const Surfels& surfels, const Buffer<float>& radiance) {
    const auto count = static_cast<std::size_t>(surfels.count);
    const std::vector<float> rgb = radiance.read_rows(0, static_cast<std::size_t>(surfels.capacity), 3, count);
    std::vector<float> light(count);
    for (std::size_t i = 0; i < count; ++i) {
        const float sum = rgb[i] + rgb[count + i] + rgb[2 * count + i];
        light[i] = std::isfinite(sum) ? std::max(sum, 0.0F) : 0.0F;
    }
    return light;
}

}  // namespace pencil
