#include "line/placement/profile_candidates.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "image/colour.h"
#include "pencils/low_discrepancy.h"
#include "pencils/place_pencils.h"
#include "visibility/geometry_maps.h"

namespace pencil {

namespace {

/// Points looked at for each candidate, and the width of their maps, the smallest that exists.
constexpr int points_per_candidate = 4;
constexpr int profile_map = 8;
/// Share of the weight that every point has: light that the profile does not see must find a pencil, too.
constexpr double defensive = 0.25;

/// Scales to mean 1; all 1 if there is nothing.
void normalise(std::vector<double>& weights) {
    const double mean = std::accumulate(weights.begin(), weights.end(), 0.0) / static_cast<double>(weights.size());
    for (double& w : weights) w = mean > 0 && std::isfinite(mean) ? w / mean : 1.0;
}

/// Indices of `count` points without repetition, in proportion to weight (Efraimidis and Spirakis 2006).
std::vector<std::size_t> choose_by_weight(const std::vector<double>& weights, int count, std::uint64_t seed, std::uint64_t stream) {
    std::vector<double> keys;
    for (std::size_t i = 0; i < weights.size(); ++i) keys.push_back(-std::log1p(-random_unit(seed, stream, i)) / weights[i]);
    std::vector<std::size_t> order(weights.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
    order.resize(static_cast<std::size_t>(count));
    return order;
}

}  // namespace

std::vector<double> visible_area(const FlatScene& flat, const GeometryMaps& maps) {
    const std::vector<Hit> hits = maps.hits.read();
    const std::vector<float4> centres = maps.cops.read();
    const int n = maps.n, stride = PENCIL_TILE_STRIDE(n);
    std::vector<double> areas;
    for (int tile = 0; tile < maps.count; ++tile) {
        double sum = 0, all = 0;
        for (int k = 0; k < maps.texels(); ++k) {
            const int column = k % n, row = k / n, gutters = 2 * PENCIL_GUTTER * (row / n) + PENCIL_GUTTER;
            const TexelView view = texel_view(maps.shape, column, row);
            all += view.solid_angle;
            const Hit& hit = hits[static_cast<std::size_t>(tile) * static_cast<std::size_t>(maps.stored()) +
                                  static_cast<std::size_t>((row + gutters) * stride + column + PENCIL_GUTTER)];
            if (hit.triangle < 0) continue;
            const Triangle& t = flat.triangles[static_cast<std::size_t>(hit.triangle)];
            const float4 plane = flat.planes[static_cast<std::size_t>(t.plane)];
            const glm::vec4 albedo = flat.materials[static_cast<std::size_t>(t.material)].albedo;
            const bool front = glm::dot(glm::vec3(plane), glm::vec3(centres[static_cast<std::size_t>(tile)])) > plane.w;
            const bool reflects = luminance(glm::dvec3(albedo)) > 0 && (front || albedo.w != 0.0F);
            const double distance = glm::length(view.direction) / static_cast<double>(hit.disparity);
            if (reflects) sum += view.solid_angle * distance * distance;
        }
        areas.push_back(sum / all);
    }
    return areas;
}

std::vector<float4> ProfileCandidates::place(const CandidateQuery& query) {
    const int points = points_per_candidate * query.count;
    const std::vector<float4> centres =
        place_pencils(scene_.flat, Sequence::low_discrepancy, points_per_candidate * query.first, points, query.set, scene_.seed);
    auto maps =
        std::make_shared<GeometryMaps>(scene_.kernels.device(), centres, scene_.kernels.map_shape(profile_map), "illumination profile");
    make_geometry_maps(scene_.kernels, scene_.device_scene, *maps, 0, maps->count);
    std::vector<double> weights = visible_area(scene_.flat, *maps);
    normalise(weights);
    if (query.power) {
        const std::vector<float4> power = query.power(maps);
        for (std::size_t i = 0; i < weights.size(); ++i) weights[i] *= luminance(glm::dvec3(power[i]));
        normalise(weights);
    }
    for (double& w : weights) w = defensive + (1.0 - defensive) * w;
    const std::uint64_t stream = hash64(static_cast<std::uint64_t>(Placement::profile) + 1) ^ static_cast<std::uint64_t>(query.set);
    std::vector<float4> chosen;
    for (std::size_t i : choose_by_weight(weights, query.count, scene_.seed ^ static_cast<std::uint64_t>(query.first), stream))
        chosen.push_back(centres[i]);
    return chosen;
}

}  // namespace pencil
