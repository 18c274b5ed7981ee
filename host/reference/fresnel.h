// Reflection and refraction at a boundary between two media, by Fresnel's equations for unpolarised light.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace pencil {

struct Fresnel {
    float reflected;      // share of power, in [0, 1]
    float cos_refracted;  // of the angle to the normal on the other side; 0 if all is reflected
};

/// Between dielectrics. `cosine` >= 0 on this side, `eta`: index on the other side over that on this one.
inline Fresnel fresnel_dielectric(float cosine, float eta) {
    const float c = std::min(std::abs(cosine), 1.0F), sin2 = (1.0F - c * c) / (eta * eta);
    if (!(sin2 < 1.0F)) return {1.0F, 0.0F};
    const float t = std::sqrt(1.0F - sin2), s = (c - eta * t) / (c + eta * t), p = (eta * c - t) / (eta * c + t);
    return {0.5F * (s * s + p * p), t};
}

/// Of a conductor of complex index eta + i k, from outside (Born and Wolf, 14.2, in the form of Lazanyi and Szirmay-Kalos 2005).
inline float fresnel_conductor(float cosine, float eta, float k) {
    const double c2 = std::min(static_cast<double>(cosine) * cosine, 1.0), s2 = 1 - c2, n2 = static_cast<double>(eta) * eta,
                 k2 = static_cast<double>(k) * k, d = n2 - k2 - s2;
    const double ab2 = std::sqrt(d * d + 4 * n2 * k2), a2 = std::max(0.5 * (ab2 + d), 0.0), c = std::sqrt(c2),
                 twice = 2 * std::sqrt(a2) * c;
    const double s = (ab2 + c2 - twice) / (ab2 + c2 + twice);
    const double p = s * (c2 * ab2 + s2 * s2 - twice * s2) / (c2 * ab2 + s2 * s2 + twice * s2);
    return static_cast<float>(0.5 * (s + p));
}

inline glm::vec3 reflect_about(const glm::vec3& omega, const glm::vec3& m) { return 2.0F * glm::dot(omega, m) * m - omega; }

/// Unit direction on the other side of the facet `m`; dot(omega, m) > 0.
inline glm::vec3 refract_about(const glm::vec3& omega, const glm::vec3& m, float cos_refracted, float eta) {
    return (glm::dot(omega, m) / eta - cos_refracted) * m - omega / eta;
}

}  // namespace pencil
