// Which surface pencils light a point, by trying all of them, and what they send: double precision, no grid (docs/overview.md, "The surface
// method").
#pragma once

#include <vector>

#include "reference/surface_pencil_ref.h"

namespace pencil::ref {

struct Link {
    int pencil;
    double weight;
};
using Links = std::vector<Link>;

constexpr std::size_t most_links = 4;

struct FoundLinks {
    Links links;          // at most four, of weights that sum to 1, the greatest first
    double margin = 1.0;  // relative distance from the nearest decision
};

/// Pencils may be used within their radius, where normals are alike, x lies on their surface and no horizon is passed. They count by
/// (1/radius - distance/radius^2)^2 cos, the best four.
inline FoundLinks find_links(const std::vector<SurfacePencil>& pencils, const dvec3& x, const dvec3& n) {
    FoundLinks out;
    for (std::size_t i = 0; i < pencils.size(); ++i) {
        const SurfacePencil& p = pencils[i];
        const dvec3 step = x - xyz(p.position), normal = xyz(p.normal);
        const double radius = p.normal.w, distance = glm::length(step), cosine = glm::dot(normal, n);
        if (!(radius > 0.0)) continue;
        double margin = std::abs(distance / radius - 1.0);
        if (distance < radius * 1.01) margin = std::min(margin, std::abs(cosine - least_cosine));
        const bool reaches = distance < radius && cosine >= least_cosine && horizon_depth(p, step, margin) < 1.0;
        const double most_rise = most_slope * distance + 0.5 * no_step(x), rise = 0.5 * std::abs(glm::dot(step, normal + n));
        if (reaches) margin = std::min(margin, std::abs(rise - most_rise) / std::max(most_rise, 1e-3));
        out.margin = std::min(out.margin, margin);
        if (!reaches || rise > most_rise) continue;
        const double closeness = (1.0 - distance / radius) / radius;
        out.links.push_back({static_cast<int>(i), closeness * closeness * cosine});
    }
    std::stable_sort(out.links.begin(), out.links.end(), [](const Link& a, const Link& b) { return a.weight > b.weight; });
    for (std::size_t k = 0; k + 1 < std::min(out.links.size(), most_links + 1); ++k)  // their order
        out.margin = std::min(out.margin, (out.links[k].weight - out.links[k + 1].weight) / out.links[k].weight);
    if (out.links.size() > most_links) out.links.resize(most_links);
    double sum = 0;
    for (const Link& link : out.links) sum += link.weight;
    for (Link& link : out.links) link.weight /= sum;
    return out;
}

/// True if the pencil may stand in for a point that has no links: it faces the same way and has a clear horizon.
/// `margin`: as in FoundLinks, lowered.
inline bool may_stand_in(const SurfacePencil& p, const dvec3& x, const dvec3& n, double& margin) {
    const double cosine = glm::dot(xyz(p.normal), n);
    margin = std::min(margin, std::abs(cosine - least_cosine));
    return cosine >= least_cosine && horizon_depth(p, x - xyz(p.position), margin) < 1.0;
}

/// The weighted sum of the pencils' irradiance.
inline dvec3 linked_irradiance(const Links& links, const std::vector<float4>& irradiance) {
    dvec3 sum(0);
    for (const Link& link : links) sum += link.weight * xyz(irradiance[static_cast<std::size_t>(link.pencil)]);
    return sum;
}

}  // namespace pencil::ref
