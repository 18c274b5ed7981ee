#include "reference/plastic_table.h"

#include <algorithm>
#include <cmath>

#include "reference/fresnel.h"
#include "reference/microfacets.h"

namespace pencil {
namespace {

constexpr int cosines = 64;       // as many as Mitsuba's roughplastic has
constexpr int varied_levels = 9;  // of a roughness that varies
constexpr int points = 48;        // per dimension, for the integral over visible facets

/// What rough and smooth boundaries reflect and let through; facets that shadow each other lose light (Walter et al. 2007).
struct Split {
    double reflected = 0, transmitted = 0;
};

Split split_smooth(float cosine, float eta) {
    const double r = fresnel_dielectric(cosine, eta).reflected;
    return {r, 1 - r};
}

Split split_rough(float cosine, float eta, float alpha, bool beckmann) {
    const Microfacets facets(glm::vec2(alpha), beckmann);
    const glm::vec3 omega(std::sqrt(1.0F - cosine * cosine), 0.0F, cosine);
    Split sum;
    for (int i = 0; i < points; ++i)
        for (int k = 0; k < points; ++k) {
            const glm::vec3 m = facets.sample(omega, (glm::dvec2(i, k) + 0.5) / double(points));
            const Fresnel f = fresnel_dielectric(glm::dot(omega, m), eta);
            const glm::vec3 back = reflect_about(omega, m), on = refract_about(omega, m, f.cos_refracted, eta);
            if (back.z > 0.0F) sum.reflected += static_cast<double>(f.reflected * facets.visible(back, m));
            if (f.reflected < 1.0F && on.z < 0.0F) sum.transmitted += (1.0 - f.reflected) * facets.visible(on, m);
        }
    return {sum.reflected / (points * points), sum.transmitted / (points * points)};
}

/// 2 times the integral of R(mu) mu over [0, 1]: of a smooth boundary by the midpoint rule. Rough ones take the mean over the table's
/// cosines, both ends included, as Mitsuba's roughplastic defines itself: it is 1.5 % below the integral.
double inside_of_smooth(float eta) {
    constexpr int steps = 4096;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double mu = (i + 0.5) / steps;
        sum += 2 * mu * split_smooth(static_cast<float>(mu), 1.0F / eta).reflected / steps;
    }
    return sum;
}

float cosine_at(int i) { return std::max(static_cast<float>(i) / (cosines - 1), 1e-6F); }

}  // namespace

PlasticTable::PlasticTable(float eta, float alpha, bool beckmann, bool varies) : alpha_(varies ? alpha : 0.0F) {
    const int levels = varies ? varied_levels : 1;
    for (int l = 0; l < levels; ++l) {
        const float a = varies ? alpha * static_cast<float>(l) / static_cast<float>(levels - 1) : alpha;
        std::vector<float> row;
        double inside = 0;
        for (int i = 0; i < cosines; ++i) {
            const float mu = cosine_at(i);
            const bool smooth = !(alpha > 0.0F);
            row.push_back(static_cast<float>((smooth ? split_smooth(mu, eta) : split_rough(mu, eta, a, beckmann)).transmitted));
            if (!smooth) inside += 2 * mu * split_rough(mu, 1.0F / eta, a, beckmann).reflected / cosines;
        }
        transmitted_.push_back(row);
        inside_.push_back(static_cast<float>(alpha > 0.0F ? inside : inside_of_smooth(eta)));
    }
}

/// Of the table, between its rows.
double PlasticTable::level(float alpha) const {
    if (inside_.size() == 1) return 0;
    return std::clamp(static_cast<double>(alpha) / alpha_, 0.0, 1.0) * static_cast<double>(inside_.size() - 1);
}

float PlasticTable::transmitted(float cosine, float alpha) const {
    const double x = std::clamp(static_cast<double>(cosine), 0.0, 1.0) * (cosines - 1), y = level(alpha);
    const auto i = static_cast<std::size_t>(std::min(x, cosines - 2.0)), l = static_cast<std::size_t>(y);
    const auto row = [&](std::size_t k) {
        const std::vector<float>& r = transmitted_[std::min(k, transmitted_.size() - 1)];
        const double w = x - static_cast<double>(i);
        return (1 - w) * r[i] + w * r[i + 1];
    };
    const double w = y - static_cast<double>(l);
    return static_cast<float>((1 - w) * row(l) + w * row(l + 1));
}

float PlasticTable::reflected_inside(float alpha) const {
    const double y = level(alpha);
    const auto l = static_cast<std::size_t>(y), next = std::min(l + 1, inside_.size() - 1);
    const double w = y - static_cast<double>(l);
    return static_cast<float>((1 - w) * inside_[l] + w * inside_[next]);
}

}  // namespace pencil
