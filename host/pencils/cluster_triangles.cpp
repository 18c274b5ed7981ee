#include "pencils/cluster_triangles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <utility>

namespace pencil {

namespace {

/// Boxes are wider than their triangles by this, so that rounding cuts nothing off (PLANE_TOLERANCE of kernels/lib/triangle.cl).
constexpr float cluster_margin = 1e-6F;
/// Bits of each coordinate along the curve.
constexpr int curve_bits = 10;
/// Triangles whose extents differ by more than this factor are kept apart: one wall would blow up the box of small things beside it.
constexpr float size_step = 8.0F;
constexpr int largest_size = 7;

/// Moves bit k to bit 3 k.
std::uint32_t spread(std::uint32_t v) {
    v = (v | v << 16) & 0x030000ffU;
    v = (v | v << 8) & 0x0300f00fU;
    v = (v | v << 4) & 0x030c30c3U;
    return (v | v << 2) & 0x09249249U;
}

struct TriangleBox {
    float4 low, high;
};

TriangleBox box_of(const Triangle& t) { return {glm::min(glm::min(t.v0, t.v1), t.v2), glm::max(glm::max(t.v0, t.v1), t.v2)}; }

/// Class of size, large first, then place along the curve. Coordinates are those of a normalised scene.
std::uint64_t curve_key(const Triangle& triangle) {
    const TriangleBox box = box_of(triangle);
    const float4 extent = box.high - box.low;
    const float size = std::max({extent.x, extent.y, extent.z, 1e-6F});
    const int smallness = std::clamp(static_cast<int>(-std::log(size) / std::log(size_step)), 0, largest_size);
    const float4 place = (0.25F * (box.low + box.high) + 0.5F) * static_cast<float>(1 << curve_bits);
    const auto cell = [](float x) {
        return spread(static_cast<std::uint32_t>(std::clamp(x, 0.0F, static_cast<float>((1 << curve_bits) - 1))));
    };
    const std::uint32_t code = cell(place.x) << 2 | cell(place.y) << 1 | cell(place.z);
    return static_cast<std::uint64_t>(smallness) << 32 | code;
}

}  // namespace

Clusters cluster_triangles(const std::vector<Triangle>& triangles) {
    std::vector<std::pair<std::uint64_t, int>> order;
    order.reserve(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) order.emplace_back(curve_key(triangles[i]), static_cast<int>(i));
    std::sort(order.begin(), order.end());
    Clusters clusters;
    clusters.members.reserve(triangles.size());
    for (const auto& entry : order) clusters.members.push_back(entry.second);
    for (std::size_t first = 0; first < triangles.size(); first += CLUSTER_TRIANGLES) {
        const std::size_t last = std::min<std::size_t>(first + CLUSTER_TRIANGLES, triangles.size());
        Cluster cluster{float4(INFINITY), float4(-INFINITY)};
        for (std::size_t m = first; m < last; ++m) {
            const TriangleBox box = box_of(triangles[static_cast<std::size_t>(clusters.members[m])]);
            cluster.low = glm::min(cluster.low, box.low - cluster_margin);
            cluster.high = glm::max(cluster.high, box.high + cluster_margin);
        }
        const auto begin = clusters.members.begin();
        std::sort(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last));
        clusters.boxes.push_back(cluster);
    }
    clusters.count = static_cast<int>(clusters.boxes.size());
    for (std::size_t first = 0; first < static_cast<std::size_t>(clusters.count); first += CLUSTER_GROUP) {
        Cluster group = clusters.boxes[first];
        for (std::size_t c = first; c < std::min<std::size_t>(first + CLUSTER_GROUP, static_cast<std::size_t>(clusters.count)); ++c) {
            group.low = glm::min(group.low, clusters.boxes[c].low);
            group.high = glm::max(group.high, clusters.boxes[c].high);
        }
        clusters.boxes.push_back(group);
    }
    return clusters;
}

}  // namespace pencil
