#include "surface/near_lights.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "util/constants.h"

namespace pencil {

namespace {

/// A light is near what is closer than this share of the spacing of pencils: from there on texels find what it lights.
constexpr float near_share = 0.25F;
/// Radius of the smallest sphere in distances of the light: three quarters of what a plane receives. Each further one is so many times as wide.
constexpr float first_ring = 4, ring_step = 8;
/// Share of all that is reflected below which spots are not worth their rays.
constexpr double least_share = 0.02;
/// About what share of light surfaces reflect, where only light is known.
constexpr double usual_albedo = 0.5;
/// Cosines at which rays meet surfaces are taken to be at least this.
constexpr float least_cosine = 0.02F;

}  // namespace

std::vector<Spot> near_light_spots(const std::vector<LightHit>& hits, float reach) {
    const auto closer = [](const LightHit& a, const LightHit& b) { return a.distance < b.distance; };
    const auto foot = std::min_element(hits.begin(), hits.end(), closer);
    if (foot == hits.end() || !(foot->distance < near_share * reach)) return {};
    std::vector<Spot> spots;
    float inner = -1;
    for (float radius = first_ring * std::max(foot->distance, std::numeric_limits<float>::min()); inner < reach;
         inner = radius, radius *= ring_step) {
        Spot spot{foot->position, radius, 0};
        for (const LightHit& hit : hits) {
            const float apart = glm::distance(hit.position, foot->position);
            if (std::isfinite(hit.distance) && apart > inner && apart <= radius) spot.weight += static_cast<float>(hit.flux);
        }
        if (spot.weight > 0 && radius <= reach) spots.push_back(spot);
    }
    return spots;
}

std::vector<Spot> near_light_spots(const std::vector<SmallLight>& lights, const Surfels& met, const Buffer<float>& radiance, float reach,
                                   double power) {
    const auto count = static_cast<std::size_t>(met.count), capacity = static_cast<std::size_t>(met.capacity);
    const std::vector<float> s = met.data.read_rows(0, capacity, SURFEL_NZ + 1, count), rgb = radiance.read_rows(0, capacity, 3, count);
    constexpr std::size_t each = probe_map * probe_map;
    std::vector<Spot> spots;
    double reflected = 0;
    std::size_t probe = 0;
    for (const SmallLight& light : lights) {
        std::vector<LightHit> hits;
        // Two probes of a point see each surface once, all of a lamp as often as there are.
        const double views = light.extent > 0 ? static_cast<double>(light.places.size()) : 1;
        for (std::size_t k = 0; k < light.places.size(); ++k, ++probe)
            for (std::size_t i = probe * each; i < (probe + 1) * each; ++i) {
                const glm::vec3 position(s[i], s[count + i], s[2 * count + i]),
                    normal(s[3 * count + i], s[4 * count + i], s[5 * count + i]);
                const float sum = rgb[i] + rgb[count + i] + rgb[2 * count + i];
                const glm::vec3 step = position - light.places[k];
                const float distance = glm::length(step);
                if (!(glm::dot(normal, normal) > 0) || !(distance > 0) || !std::isfinite(sum)) continue;
                // The texel's part of the sphere, and of the surface.
                const float up = std::max(glm::dot(step, light.normals[k]) / distance, least_cosine),
                            lean = std::max(std::abs(glm::dot(step, normal)) / distance, least_cosine);
                const double area = pi / each / static_cast<double>(up * lean) * static_cast<double>(distance * distance);
                hits.push_back({position, distance, pi * area * static_cast<double>(std::max(sum, 0.0F)) / views});
            }
        if (light.extent > reach) continue;
        for (const Spot& spot : near_light_spots(hits, reach)) {
            spots.push_back(spot);
            reflected += static_cast<double>(spot.weight);
        }
    }
    if (!(reflected > least_share * usual_albedo * power)) return {};
    for (Spot& spot : spots) spot.weight = static_cast<float>(static_cast<double>(spot.weight) / (usual_albedo * power));
    return spots;
}

}  // namespace pencil
