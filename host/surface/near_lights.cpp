#include "surface/near_lights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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
constexpr std::size_t probe_texels = probe_map * probe_map;

/// What all probes met: fields of surfels from their positions to their normals, and what they send, both [field][count].
struct Met {
    std::size_t count;
    std::vector<float> surfels, rgb;
    glm::vec3 vector(int field, std::size_t i) const {
        const std::size_t at = static_cast<std::size_t>(field) * count + i;
        return {surfels[at], surfels[at + count], surfels[at + 2 * count]};
    }
    float light(std::size_t i) const { return rgb[i] + rgb[count + i] + rgb[2 * count + i]; }
};

/// What the probes of a light met, from number `first` on.
std::vector<LightHit> hits_of(const SmallLight& light, const Met& met, std::size_t first) {
    std::vector<LightHit> hits;
    // Two probes of a point see each surface once, all of a lamp as often as there are.
    const double views = light.extent > 0 ? static_cast<double>(light.places.size()) : 1;
    for (std::size_t k = 0; k < light.places.size() * probe_texels; ++k) {
        const std::size_t i = first + k, probe = k / probe_texels;
        const glm::vec3 position = met.vector(SURFEL_X, i), normal = met.vector(SURFEL_NX, i), step = position - light.places[probe];
        const float sum = met.light(i), distance = glm::length(step);
        if (!(glm::dot(normal, normal) > 0) || !(distance > 0) || !std::isfinite(sum)) continue;
        // The texel's part of the sphere, and of the surface.
        const float up = std::max(glm::dot(step, light.normals[probe]) / distance, least_cosine),
                    lean = std::max(std::abs(glm::dot(step, normal)) / distance, least_cosine);
        const double area = pi / probe_texels / static_cast<double>(up * lean) * static_cast<double>(distance * distance);
        hits.push_back({position, distance, pi * area * static_cast<double>(std::max(sum, 0.0F)) / views});
    }
    return hits;
}

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
    const Met all{count, met.data.read_rows(0, capacity, SURFEL_NZ + 1, count), radiance.read_rows(0, capacity, 3, count)};
    std::vector<Spot> spots;
    double reflected = 0;
    std::size_t first = 0;
    for (const SmallLight& light : lights) {
        const std::size_t begin = std::exchange(first, first + light.places.size() * probe_texels);
        if (light.extent > reach) continue;
        for (const Spot& spot : near_light_spots(hits_of(light, all, begin), reach)) {
            spots.push_back(spot);
            reflected += static_cast<double>(spot.weight);
        }
    }
    if (!(reflected > least_share * usual_albedo * power)) return {};
    for (Spot& spot : spots) spot.weight = static_cast<float>(static_cast<double>(spot.weight) / (usual_albedo * power));
    return spots;
}

}  // namespace pencil
