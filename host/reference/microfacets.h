// Distributions of microfacets, GGX and Beckmann, with Smith's masking (Walter et al. 2007; Heitz 2014). Vectors are those of the shading
// frame; facets face up.
#pragma once

#include <glm/glm.hpp>

namespace pencil {

class Microfacets {
public:
    /// `alpha`: roughness along x and y; below 1e-4 it is 1e-4 (Mitsuba).
    Microfacets(const glm::vec2& alpha, bool beckmann) : alpha_(glm::max(alpha, glm::vec2(1e-4F))), beckmann_(beckmann) {}

    /// Density D of facet normals by area [1/sr].
    float density(const glm::vec3& m) const;
    /// Share of facets `m` that are seen from `omega`; 0 if it looks at their backs, or at the surface's other side than they.
    float visible(const glm::vec3& omega, const glm::vec3& m) const;
    /// Facets that omega, above the horizon, sees, as often as it sees them.
    glm::vec3 sample(const glm::vec3& omega, const glm::dvec2& u) const;
    /// Density of `sample` [1/sr].
    float pdf(const glm::vec3& omega, const glm::vec3& m) const { return visible(omega, m) * glm::dot(omega, m) * density(m) / omega.z; }

private:
    glm::vec2 alpha_;
    bool beckmann_;
};

}  // namespace pencil
