// Reflection in double precision, from the definitions: what comes in from a direction and leaves into another, local frame, z the normal.
#pragma once

#include <cmath>
#include <functional>
#include <glm/vec3.hpp>

namespace pencil::ref {

using glm::dvec3;
constexpr double brdf_pi = 3.14159265358979323846;

/// f(omega_o, omega_i) [1/sr] for an albedo.
using Reflection = std::function<dvec3(const dvec3& albedo, const dvec3& omega_o, const dvec3& omega_i)>;

/// Lambert: a white surface sends 1/pi of the irradiance into every direction.
inline dvec3 lambert(const dvec3& albedo, const dvec3& omega_o, const dvec3& omega_i) {
    return omega_o.z <= 0.0 || omega_i.z <= 0.0 ? dvec3(0.0) : albedo / brdf_pi;
}

/// Lommel and Seeliger: light goes down to depth t along omega_i and comes back along omega_o, so of each layer exp(-t / mu_i - t / mu_o)
/// reaches the eye; the layers scatter w / (4 pi) evenly. The integral over depth is done here as it stands, by Simpson's rule in
/// s = exp(-t), so that nothing of the closed form is in the reference.
inline dvec3 lommel_seeliger(const dvec3& albedo, const dvec3& omega_o, const dvec3& omega_i) {
    if (omega_o.z <= 0.0 || omega_i.z <= 0.0) return dvec3(0.0);
    // integral of exp(-t (1/mu_i + 1/mu_o)) dt = integral of s^(k - 1) ds over [0, 1], k >= 2; s = q^2 smooths it at 0.
    const double k = 1.0 / omega_i.z + 1.0 / omega_o.z;
    const int steps = 4000;
    double sum = 0.0;
    for (int i = 0; i <= steps; ++i) {
        const double q = static_cast<double>(i) / steps, value = 2.0 * std::pow(q, 2.0 * k - 1.0);
        sum += value * (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0);
    }
    const double depth = sum / (3.0 * steps);
    // Radiance per irradiance: the layer receives E / mu_i per unit of its own area, and is mu_o foreshortened to the eye.
    return albedo / (4.0 * brdf_pi) * depth / (omega_i.z * omega_o.z);
}

/// Direction at height z and azimuth phi.
inline dvec3 direction_at(double z, double phi) {
    const double r = std::sqrt(std::fmax(1.0 - z * z, 0.0));
    return {r * std::cos(phi), r * std::sin(phi), z};
}

}  // namespace pencil::ref
