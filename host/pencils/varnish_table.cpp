#include "pencils/varnish_table.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/packing.hpp>

#include "util/constants.h"

namespace pencil {

namespace {

/// Steps of the integral over microfacets, by each of two angles.
constexpr int steps = 64;

double reflectance(double cosine, double eta) {
    const double square = 1 - (1 - cosine * cosine) / (eta * eta);
    if (square <= 0) return 1;
    const double t = std::sqrt(square), s = (cosine - eta * t) / (cosine + eta * t), p = (t - eta * cosine) / (t + eta * cosine);
    return 0.5 * (s * s + p * p);
}

/// Share of microfacets that are seen from a direction of cosine z (Walter et al. 2007).
double seen(bool beckmann, double alpha, double z) {
    const double t = alpha * std::sqrt(std::max(1 - z * z, 0.0)) / z;
    if (!beckmann) return 2 / (1 + std::sqrt(1 + t * t));
    const double a = 1 / t;
    return t == 0 || a >= 1.6 ? 1 : (3.535 * a + 2.181 * a * a) / (1 + 2.276 * a + 2.577 * a * a);
}

struct Split {
    double reflected = 0, passes = 0;
};

struct Facet {
    glm::dvec3 normal;
    double weight;  // of those that o sees
};

/// A microfacet for u, v in (0, 1): GGX by those that o sees (Heitz 2018), Beckmann by D cos.
Facet facet(bool beckmann, double alpha, const glm::dvec3& o, double u, double v) {
    if (beckmann) {
        const double square = -alpha * alpha * std::log(1 - u), z = 1 / std::sqrt(1 + square), r = std::sqrt(std::max(1 - z * z, 0.0));
        const glm::dvec3 h(r * std::cos(2 * pi * v), r * std::sin(2 * pi * v), z);
        return {h, seen(true, alpha, o.z) * std::max(glm::dot(o, h), 0.0) / (o.z * z)};
    }
    const glm::dvec3 s = glm::normalize(glm::dvec3(alpha * o.x, 0, o.z)), t(0, 1, 0), b = glm::cross(s, t);
    const double x = std::sqrt(u) * std::cos(2 * pi * v), w = 0.5 * (1 + s.z);
    const double y = (1 - w) * std::sqrt(std::max(1 - x * x, 0.0)) + w * std::sqrt(u) * std::sin(2 * pi * v);
    const glm::dvec3 n = x * t + y * b + std::sqrt(std::max(1 - x * x - y * y, 0.0)) * s;
    return {glm::normalize(glm::dvec3(alpha * n.x, alpha * n.y, std::max(n.z, 1e-9))), 1};
}

/// What microfacets of a boundary of this index do to light from direction o, once; what others shadow is lost.
Split split(const SceneMaterial& m, double eta, double alpha, double cosine) {
    const glm::dvec3 o(std::sqrt(std::max(1 - cosine * cosine, 0.0)), 0, cosine);
    Split sum;
    for (int i = 0; i < steps; ++i)
        for (int k = 0; k < steps; ++k) {
            const Facet h = facet(m.beckmann, alpha, o, (i + 0.5) / steps, (k + 0.5) / steps);
            const double c = glm::dot(o, h.normal), back = 2 * c * h.normal.z - o.z;
            if (!(c > 0)) continue;
            const double f = reflectance(c, eta);
            if (back > 0) sum.reflected += h.weight * f * seen(m.beckmann, alpha, back);
            if (f >= 1) continue;
            const double on = (c / eta - std::sqrt(1 - (1 - c * c) / (eta * eta))) * h.normal.z - o.z / eta;
            if (on < 0) sum.passes += h.weight * (1 - f) * seen(m.beckmann, alpha, -on);
        }
    const double count = steps * steps;
    return {std::min(sum.reflected / count, 1.0), std::min(sum.passes / count, 1.0)};
}

/// Share of even light from inside that a smooth boundary reflects.
double reflected_inside_smooth(double eta) {
    constexpr int cosines = 4096;
    double sum = 0;
    for (int i = 0; i < cosines; ++i) {
        const double cosine = (i + 0.5) / cosines;
        sum += 2 * cosine * reflectance(cosine, 1 / eta) / cosines;
    }
    return sum;
}

/// The same of a rough one; Mitsuba's roughplastic defines itself by this mean over 64 cosines, both ends included, which is 1.5 % below the
/// integral.
double reflected_inside(const SceneMaterial& m, double alpha) {
    if (!(m.alpha.x > 0.0F)) return reflected_inside_smooth(static_cast<double>(m.eta.x));
    constexpr int cosines = 64;
    double sum = 0;
    for (int i = 1; i < cosines; ++i) {
        const double cosine = static_cast<double>(i) / (cosines - 1);
        sum += 2 * cosine * split(m, 1 / static_cast<double>(m.eta.x), alpha, cosine).reflected / cosines;
    }
    return sum;
}

std::uint64_t packed(double first, double second = 0) {
    return glm::packHalf4x16(glm::vec4(static_cast<float>(first), static_cast<float>(second), 0.0F, 0.0F));
}

}  // namespace

VarnishTable add_varnish_table(const SceneMaterial& material, std::vector<std::uint64_t>& texels) {
    VarnishTable table{static_cast<int>(texels.size()), material.alpha.x, 0};
    constexpr int angles = VARNISH_COLUMNS - 1;
    const bool varies = material.alpha_texture >= 0;
    if (varies) table = {table.first, 0, (VARNISH_ROWS - 1) / material.alpha.x};
    for (int row = 0; row < (varies ? VARNISH_ROWS : 2); ++row) {
        const double share = varies ? static_cast<double>(row) / (VARNISH_ROWS - 1) : 1;
        const double alpha = std::max(share * static_cast<double>(material.alpha.x), 1e-3);
        double mean = 0;
        for (int column = 0; column < angles; ++column) {
            const double cosine = std::max(static_cast<double>(column) / (angles - 1), 0.01),

                         passes = split(material, static_cast<double>(material.eta.x), alpha, cosine).passes;
            texels.push_back(packed(passes));
            // Of passes linear between the columns, times 2 cos.
            const double weight = column == 0 ? 1.0 / 3 : column == angles - 1 ? angles - 1 - 1.0 / 3 : 2.0 * column;
            mean += passes * weight / ((angles - 1.0) * (angles - 1.0));
        }
        texels.push_back(packed(mean, reflected_inside(material, alpha)));
    }
    return table;
}

}  // namespace pencil
