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
    Links links;               // at most four, of weights that sum to 1, the greatest first
    bool last_resort = false;  // the only one, although x does not lie on its surface
    double margin = 1.0;       // relative distance from the nearest decision
};

/// Pencils may be used within their radius, where normals are alike and no horizon is passed. Those on whose surface x lies count by
/// (1/radius - distance/radius^2)^2 cos, the best four; if there are none, the nearest of the others stands for the light, and if there is none of these either, the
/// one that faces the same way and is least far in terms of its radius.
inline FoundLinks find_links(const std::vector<SurfacePencil>& pencils, const dvec3& x, const dvec3& n) {
    FoundLinks out;
    double nearest = infinite, second_nearest = infinite, least_far = infinite, second_far = infinite;
    int last = -1, far = -1;
    for (std::size_t i = 0; i < pencils.size(); ++i) {
        const SurfacePencil& p = pencils[i];
        const dvec3 step = x - xyz(p.position), normal = xyz(p.normal);
        const double radius = p.normal.w, distance = glm::length(step), cosine = glm::dot(normal, n);
        if (!(radius > 0.0)) continue;
        if (cosine >= least_cosine) {
            const double ratio = distance * distance / (radius * radius);
            second_far = std::min(second_far, std::max(ratio, least_far));
            if (ratio < least_far) far = static_cast<int>(i);
            least_far = std::min(least_far, ratio);
        }
        const bool within = distance < radius;
        double margin = std::abs(distance / radius - 1.0);
        if (distance < radius * 1.01) margin = std::min(margin, std::abs(cosine - least_cosine));
        const bool reaches = within && cosine >= least_cosine && horizon_depth(p, step, margin) < 1.0;
        const double most_rise = most_slope * distance + 0.5 * no_step(x), rise = 0.5 * std::abs(glm::dot(step, normal + n));
        if (reaches) margin = std::min(margin, std::abs(rise - most_rise) / std::max(most_rise, 1e-3));
        out.margin = std::min(out.margin, margin);
        if (!reaches) continue;
        if (rise <= most_rise) {
            const double closeness = (1.0 - distance / radius) / radius;
            out.links.push_back({static_cast<int>(i), closeness * closeness * cosine});
        }
        second_nearest = std::min(second_nearest, std::max(distance, nearest));
        if (distance >= nearest) continue;
        nearest = distance;
        last = static_cast<int>(i);
    }
    std::stable_sort(out.links.begin(), out.links.end(), [](const Link& a, const Link& b) { return a.weight > b.weight; });
    for (std::size_t k = 0; k + 1 < std::min(out.links.size(), most_links + 1); ++k)  // their order
        out.margin = std::min(out.margin, (out.links[k].weight - out.links[k + 1].weight) / out.links[k].weight);
    if (out.links.size() > most_links) out.links.resize(most_links);
    double sum = 0;
    for (const Link& link : out.links) sum += link.weight;
    for (Link& link : out.links) link.weight /= sum;
    if (out.links.empty() && last >= 0) {
        out.links.push_back({last, 1.0});
        out.last_resort = true;
        out.margin = std::min(out.margin, second_nearest - nearest);
    } else if (out.links.empty() && far >= 0) {
        out.links.push_back({far, 1.0});
        out.last_resort = true;
        out.margin = std::min(out.margin, (second_far - least_far) / std::max(least_far, 1e-6));
        for (const SurfacePencil& p : pencils) out.margin = std::min(out.margin, std::abs(glm::dot(xyz(p.normal), n) - least_cosine));
    }
    return out;
}

/// The weighted sum of the pencils' irradiance.
inline dvec3 linked_irradiance(const Links& links, const std::vector<float4>& irradiance) {
    dvec3 sum(0);
    for (const Link& link : links) sum += link.weight * xyz(irradiance[static_cast<std::size_t>(link.pencil)]);
    return sum;
}

}  // namespace pencil::ref
