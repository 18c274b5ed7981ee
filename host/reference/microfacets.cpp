#include "reference/microfacets.h"

#include <algorithm>
#include <cmath>

#include "util/constants.h"

namespace pencil {
namespace {

constexpr double root_pi = 1.77245385090551602730;

/// Inverse of erf on (-1, 1): Giles's first guess (2010), then Newton's iteration.
double inverse_erf(double y) {
    y = std::clamp(y, -1 + 1e-15, 1 - 1e-15);
    const double w = -std::log((1 - y) * (1 + y));
    double x = w < 5 ? y * (1.50140941 + (w - 2.5) * (0.246640727 + (w - 2.5) * (-0.00417768164 - 0.00125372503 * (w - 2.5))))
                     : std::copysign(std::sqrt(std::max(w - 0.5 * std::log(w * pi), 0.0)), y);
    for (int i = 0; i < 4; ++i) x -= (std::erf(x) - y) * 0.5 * root_pi * std::exp(x * x);
    return x;
}

/// Slope x of a Beckmann surface of unit roughness as it is seen at an angle in the xz plane: its density is (cos - x sin) exp(-x^2), as far
/// as that is positive, and its integral is inverted here (Heitz and d'Eon 2014). Newton's iteration, kept in a shrinking interval.
double visible_beckmann_slope(double cosine, double sine, double u) {
    const auto integral = [&](double x) { return 0.5 * cosine * (1 + std::erf(x)) + sine * std::exp(-x * x) / (2 * root_pi); };
    double low = -7, high = sine > cosine / 7 ? cosine / sine : 7;
    const double target = u * integral(high);
    double x = std::clamp(0.0, low, high);
    for (int i = 0; i < 60 && high - low > 1e-9; ++i) {
        const double excess = integral(x) - target, slope = (cosine - x * sine) * std::exp(-x * x) / root_pi;
        (excess > 0 ? high : low) = x;
        const double next = slope > 0 ? x - excess / slope : low;
        if (std::abs(next - x) < 1e-9) return next;
        x = next > low && next < high ? next : 0.5 * (low + high);
    }
    return x;
}

/// Facets that `v` sees of a surface of unit roughness.
glm::dvec3 sample_unit_beckmann(const glm::dvec3& v, const glm::dvec2& u) {
    const double sine = std::hypot(v.x, v.y), cos_phi = sine > 0 ? v.x / sine : 1, sin_phi = sine > 0 ? v.y / sine : 0;
    const double x = visible_beckmann_slope(v.z, sine, u.x), y = inverse_erf(2 * u.y - 1);
    return {-(x * cos_phi - y * sin_phi), -(x * sin_phi + y * cos_phi), 1};
}

/// The same for GGX: points of the half disks that the visible hemisphere projects to (Heitz 2018).
glm::dvec3 sample_unit_ggx(const glm::dvec3& v, const glm::dvec2& u) {
    const double square = v.x * v.x + v.y * v.y;
    const glm::dvec3 t1 = square > 0 ? glm::dvec3(-v.y, v.x, 0) / std::sqrt(square) : glm::dvec3(1, 0, 0), t2 = glm::cross(v, t1);
    const double r = std::sqrt(u.x), phi = 2 * pi * u.y, s = 0.5 * (1 + v.z), p1 = r * std::cos(phi);
    const double p2 = (1 - s) * std::sqrt(1 - p1 * p1) + s * r * std::sin(phi);
    return p1 * t1 + p2 * t2 + std::sqrt(std::max(1 - p1 * p1 - p2 * p2, 0.0)) * v;
}

}  // namespace

float Microfacets::density(const glm::vec3& m) const {
    if (!(m.z > 0.0F)) return 0.0F;
    const double x = m.x / alpha_.x, y = m.y / alpha_.y, z2 = static_cast<double>(m.z) * m.z;
    const double area = pi * alpha_.x * alpha_.y;
    if (beckmann_) return static_cast<float>(std::exp(-(x * x + y * y) / z2) / (area * z2 * z2));
    const double q = x * x + y * y + z2;
    return static_cast<float>(1 / (area * q * q));
}

float Microfacets::visible(const glm::vec3& omega, const glm::vec3& m) const {
    if (!(glm::dot(omega, m) * omega.z > 0.0F)) return 0.0F;
    const float x = alpha_.x * omega.x, y = alpha_.y * omega.y, tan2 = (x * x + y * y) / (omega.z * omega.z);
    if (!beckmann_) return 2.0F / (1.0F + std::sqrt(1.0F + tan2));
    if (tan2 < 0.03F) return 1.0F;  // to single precision
    const float a = 1.0F / std::sqrt(tan2);
    return 2.0F / (1.0F + std::erf(a) + std::exp(-a * a) / (a * static_cast<float>(root_pi)));
}

glm::vec3 Microfacets::sample(const glm::vec3& omega, const glm::dvec2& u) const {
    const glm::dvec3 stretched = glm::normalize(glm::dvec3(alpha_.x * omega.x, alpha_.y * omega.y, omega.z));
    const glm::dvec3 m = beckmann_ ? sample_unit_beckmann(stretched, u) : sample_unit_ggx(stretched, u);
    return glm::vec3(glm::normalize(glm::dvec3(alpha_.x * m.x, alpha_.y * m.y, std::max(m.z, 1e-9))));
}

}  // namespace pencil
