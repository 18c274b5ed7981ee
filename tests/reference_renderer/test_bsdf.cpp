// The laws of scattering, for every model: no energy is made, both directions count alike, and samples are as dense as they say.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/bsdf.h"
#include "reference/plastic_table.h"
#include "reference/random.h"
#include "reference/shading_frame.h"

namespace {

using namespace pencil;
using ref::Random;

constexpr double pi = 3.14159265358979323846;

struct Model {
    const char* name;
    SurfaceMaterial material;
    double most = 1.0;  // that it may send back of what comes; a model that is not made to conserve energy has more
};

SurfaceMaterial of_model(int model) {
    SurfaceMaterial m;
    m.model = model;
    m.albedo = {0.2F, 0.5F, 0.9F};
    return m;
}

SurfaceMaterial conductor(const glm::vec2& alpha, bool beckmann) {
    SurfaceMaterial m = of_model(MATERIAL_CONDUCTOR);
    m.alpha = alpha;
    m.beckmann = beckmann;
    m.eta = {0.2F, 0.92F, 1.1F};
    m.k = {3.91F, 2.45F, 2.14F};
    return m;
}

SurfaceMaterial dielectric(const glm::vec2& alpha, bool beckmann, float eta) {
    SurfaceMaterial m = of_model(MATERIAL_DIELECTRIC);
    m.alpha = alpha;
    m.beckmann = beckmann;
    m.eta = glm::vec3(eta);
    m.from_inside = eta < 1.0F;
    return m;
}

SurfaceMaterial plastic(float alpha, bool beckmann, bool nonlinear) {
    static const PlasticTable smooth(1.49F, 0.0F, false, false), ggx(1.49F, 0.3F, false, true), rough(1.49F, 0.2F, true, false);
    SurfaceMaterial m = of_model(MATERIAL_PLASTIC);
    m.alpha = glm::vec2(alpha);
    m.beckmann = beckmann;
    m.nonlinear = nonlinear;
    m.eta = glm::vec3(1.49F);
    m.table = alpha <= 0.0F ? &smooth : beckmann ? &rough : &ggx;
    return m;
}

SurfaceMaterial principled(float metallic, float transmission, bool inside) {
    SurfaceMaterial m = of_model(MATERIAL_PRINCIPLED);
    m.alpha = glm::vec2(0.4F);
    m.principled = {metallic, 0.5F, transmission, 0.3F, 0.4F, 0.6F, 0.3F, 0.8F, 0.2F};
    m.eta = glm::vec3(inside ? 1.0F / 1.5F : 1.5F);
    m.from_inside = inside;
    return m;
}

std::vector<Model> models() {
    SurfaceMaterial oren = of_model(MATERIAL_ROUGH_DIFFUSE), phong = of_model(MATERIAL_PHONG);
    oren.alpha = glm::vec2(0.4F);
    phong.albedo = {0.2F, 0.3F, 0.4F};
    phong.specular = glm::vec3(0.5F);
    phong.exponent = 20.0F;
    return {{"diffuse", of_model(MATERIAL_DIFFUSE)},
            {"rough_diffuse", oren},
            {"phong", phong},
            {"conductor ggx", conductor(glm::vec2(0.3F), false)},
            {"conductor beckmann", conductor(glm::vec2(0.3F), true)},
            {"conductor anisotropic", conductor({0.1F, 0.5F}, false)},
            {"conductor anisotropic beckmann", conductor({0.5F, 0.15F}, true)},
            {"dielectric outside", dielectric(glm::vec2(0.3F), false, 1.5F)},
            {"dielectric inside", dielectric(glm::vec2(0.3F), false, 1 / 1.5F)},
            {"dielectric beckmann", dielectric({0.4F, 0.2F}, true, 1.33F)},
            {"plastic ggx", plastic(0.25F, false, false)},
            {"plastic beckmann", plastic(0.2F, true, true)},
            {"plastic smooth", plastic(0.0F, false, false)},
            {"principled base", principled(0.0F, 0.0F, false), 2.0},
            {"principled metal", principled(0.7F, 0.0F, false), 2.0},
            {"principled glass", principled(0.0F, 0.7F, false), 2.0},
            {"principled glass inside", principled(0.0F, 0.7F, true)}};
}

glm::vec3 direction(double z, double phi) {
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
}

glm::vec3 hemisphere(Random& random) { return direction(0.02 + 0.98 * random.uniform(), 2 * pi * random.uniform()); }

glm::vec3 sphere(Random& random) { return direction(2 * random.uniform() - 1, 2 * pi * random.uniform()); }

/// Integral of a function of directions over the whole sphere, by the midpoint rule.
template <typename F>
auto over_sphere(const F& f) {
    constexpr int rows = 1000, columns = 1000;
    decltype(f(glm::vec3())) sum(0);
    for (int i = 0; i < rows; ++i)
        for (int k = 0; k < columns; ++k) sum += f(direction(2 * (i + 0.5) / rows - 1, 2 * pi * (k + 0.5) / columns));
    return sum * (4 * pi / (rows * columns));
}

/// Radiance goes with the square of the index: f(o, i) / n_o^2 is symmetric (Veach 1997, 5.2).
TEST(Bsdf, IsReciprocal) {
    Random random(71);
    for (const Model& model : models()) {
        const SurfaceMaterial& m = model.material;
        SurfaceMaterial other = m;  // the other side
        other.eta = 1.0F / m.eta;
        other.from_inside = !m.from_inside;
        for (int i = 0; i < 2000; ++i) {
            const glm::vec3 a = hemisphere(random), b = sphere(random);
            if (std::abs(b.z) < 0.01F) continue;
            const glm::vec3 one = evaluate(m, a, b) / std::abs(b.z);
            const glm::vec3 back = b.z > 0.0F ? evaluate(m, b, a) / a.z : evaluate(other, -b, -a) / a.z / (m.eta.x * m.eta.x);
            for (int c = 0; c < 3; ++c) ASSERT_NEAR(one[c], back[c], 2e-3F * one[c] + 1e-5F) << model.name;
        }
    }
}

TEST(Bsdf, SamplesHaveTheDensityAndTheWeightThatTheySay) {
    Random random(73);
    for (const Model& model : models())
        for (int i = 0; i < 3000; ++i) {
            const glm::vec3 omega_o = hemisphere(random);
            const BsdfSample s = sample(model.material, omega_o, {random.uniform(), random.uniform()}, random.uniform());
            if (!(s.pdf > 0.0F) || s.delta) continue;
            ASSERT_NEAR(glm::length(s.omega_i), 1, 1e-5) << model.name;
            ASSERT_NEAR(s.pdf, pdf(model.material, omega_o, s.omega_i), 5e-3 * s.pdf) << model.name;
            const glm::vec3 value = evaluate(model.material, omega_o, s.omega_i);
            for (int c = 0; c < 3; ++c) ASSERT_NEAR(s.weight[c] * s.pdf, value[c], 5e-3 * value[c] + 1e-5) << model.name;
        }
}

/// The density integrates to the share of samples that are any, the mean weight is the integral of f cos, and that is at most 1; moments of
/// the directions are those of the density.
TEST(Bsdf, MeansOfSamplesAreIntegrals) {
    Random random(72);
    constexpr int count = 200000;
    for (const Model& model : models())
        for (const float z : {0.9F, 0.35F}) {
            const SurfaceMaterial& m = model.material;
            const glm::vec3 omega_o = direction(z, 0.7);
            glm::dvec3 weights(0), squares(0), turned(0);
            double valid = 0;
            for (int i = 0; i < count; ++i) {
                const BsdfSample s = sample(m, omega_o, {random.uniform(), random.uniform()}, random.uniform());
                if (!(s.pdf > 0.0F) || s.delta) continue;
                valid += 1.0 / count;
                weights += glm::dvec3(s.weight) / double(count);
                squares += glm::dvec3(s.weight * s.weight) / double(count);
                turned += glm::dvec3(s.omega_i) / double(count);
            }
            const double density = over_sphere([&](const glm::vec3& w) { return static_cast<double>(pdf(m, omega_o, w)); });
            const glm::dvec3 scattered = over_sphere([&](const glm::vec3& w) { return glm::dvec3(evaluate(m, omega_o, w)); });
            const glm::dvec3 mean = over_sphere([&](const glm::vec3& w) { return glm::dvec3(w) * double(pdf(m, omega_o, w)); });
            constexpr double noise = 5 / 447.0;
            EXPECT_NEAR(density, valid, 0.5 * noise + 1e-3) << model.name << " at " << z;
            const float eta = m.eta.x, denser = m.transmits() ? std::max(1.0F, 1.0F / (eta * eta)) : 1.0F;
            for (int c = 0; c < 3; ++c) {
                const double deviation = std::sqrt(std::max(squares[c] - weights[c] * weights[c], 0.0));
                EXPECT_NEAR(weights[c], scattered[c], noise * deviation + 2e-3) << model.name << " at " << z;
                EXPECT_NEAR(turned[c], mean[c], noise + 1e-3) << model.name << " at " << z;
                EXPECT_LE(scattered[c], model.most * denser + 1e-3) << model.name << " at " << z;
            }
        }
}

/// What is not lost to facets that shadow each other comes out: a white furnace. Radiance in a medium of index n counts 1 / n^2.
TEST(Bsdf, SmoothBoundariesLoseNothing) {
    for (const float z : {1.0F, 0.5F, 0.05F})
        for (const float eta : {1.5F, 1 / 1.5F, 1.0F}) {
            SurfaceMaterial glass = dielectric(glm::vec2(0.0F), false, eta);
            for (const bool thin : {false, true}) {
                glass.thin = thin;
                double sum = 0;
                constexpr int steps = 10000;
                for (int i = 0; i < steps; ++i) {
                    const BsdfSample s = sample(glass, direction(z, 1.0), {0.5, 0.5}, (i + 0.5) / steps);
                    ASSERT_TRUE(s.delta);
                    sum += s.weight.x * s.eta * s.eta / steps;
                }
                EXPECT_NEAR(sum, 1, 1e-5);
            }
        }
    SurfaceMaterial mirror = conductor(glm::vec2(0.0F), false);
    mirror.perfect_mirror = true;
    const BsdfSample s = sample(mirror, direction(0.3, 0.2), {0.5, 0.5}, 0.5);
    EXPECT_EQ(s.weight, glm::vec3(1.0F));
    EXPECT_NEAR(glm::distance(s.omega_i, direction(0.3, 0.2 + pi)), 0, 1e-6);
}

/// Nearly smooth facets reflect and refract as a smooth boundary does.
TEST(Bsdf, FacetsBecomeSmooth) {
    for (const bool beckmann : {false, true})
        for (const float eta : {1.5F, 1 / 1.5F}) {
            const SurfaceMaterial glass = dielectric(glm::vec2(1e-3F), beckmann, eta), smooth = dielectric(glm::vec2(0.0F), false, eta);
            Random random(75);
            const glm::vec3 omega_o = direction(0.8, 0.4);
            glm::dvec3 one(0), other(0);
            for (int i = 0; i < 20000; ++i) {
                const glm::dvec2 u(random.uniform(), random.uniform());
                const double lobe = random.uniform();
                const BsdfSample a = sample(glass, omega_o, u, lobe), b = sample(smooth, omega_o, u, lobe);
                one += glm::dvec3(a.omega_i * a.weight.x);
                other += glm::dvec3(b.omega_i * b.weight.x);
            }
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(one[c] / 20000, other[c] / 20000, 1e-3);
        }
}

TEST(Bsdf, FrameIsOrthonormalAndTurnsBothWays) {
    Random random(74);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 h = hemisphere(random), n = i % 2 == 0 ? h : -h, v = hemisphere(random);
        for (const ShadingFrame& frame : {ShadingFrame(n), ShadingFrame(n, sphere(random)), ShadingFrame(n, n)}) {
            EXPECT_EQ(frame.to_world({0, 0, 1}), n);
            EXPECT_LT(glm::distance(frame.to_world(frame.to_local(v)), v), 2e-6F);
            const glm::vec3 x = frame.to_world({1, 0, 0}), y = frame.to_world({0, 1, 0});
            EXPECT_LT(glm::distance(glm::cross(x, y), n), 2e-6F);
        }
    }
}

}  // namespace
