// The small side of GMRES against dense solutions: solutions, residuals, spectral radius, bases that end early.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/random.h"
#include "surface/hessenberg.h"

namespace {

using namespace pencil;
using ref::Random;
using Vector = std::vector<double>;
using Matrix = std::vector<Vector>;  // rows

double dot(const Vector& a, const Vector& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

Vector times(const Matrix& m, const Vector& v) {
    Vector out;
    for (const Vector& row : m) out.push_back(dot(row, v));
    return out;
}

/// T: rows of sum `albedo`, entries at least 0.
Matrix reflections(std::size_t n, double albedo, std::uint32_t seed) {
    Random random(seed);
    Matrix m(n, Vector(n));
    for (Vector& row : m) {
        double sum = 0;
        for (double& x : row) sum += x = random.uniform(0, 1);
        for (double& x : row) x *= albedo / sum;
    }
    return m;
}

struct Solved {
    Vector x;
    Hessenberg small;
};

/// x of (I - T) x = b by Arnoldi's method in double precision.
Solved solve(const Matrix& t, const Vector& b, std::size_t steps) {
    const double norm = std::sqrt(dot(b, b));
    Solved s{Vector(b.size(), 0.0), Hessenberg(norm)};
    std::vector<Vector> basis{b};
    for (double& x : basis[0]) x /= norm;
    for (std::size_t k = 0; k < steps && !s.small.ended(); ++k) {
        Vector w = basis[k], reflected = times(t, w), column;
        for (std::size_t i = 0; i < w.size(); ++i) w[i] -= reflected[i];
        for (const Vector& v : basis) {
            column.push_back(dot(v, w));
            for (std::size_t i = 0; i < w.size(); ++i) w[i] -= column.back() * v[i];
        }
        const double rest = std::sqrt(dot(w, w));
        column.push_back(rest > 1e-12 ? rest : 0.0);
        s.small.add(column);
        for (double& x : w) x /= rest;
        basis.push_back(w);
    }
    const Vector y = s.small.solution();
    for (std::size_t k = 0; k < y.size(); ++k)
        for (std::size_t i = 0; i < s.x.size(); ++i) s.x[i] += y[k] * basis[k][i];
    return s;
}

double residual(const Matrix& t, const Vector& b, const Vector& x) {
    const Vector reflected = times(t, x);
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += std::pow(b[i] - x[i] + reflected[i], 2);
    return std::sqrt(sum);
}

Vector random_light(std::size_t n, std::uint32_t seed) {
    Random random(seed);
    Vector b(n);
    for (double& x : b) x = random.uniform(0, 2);
    return b;
}

TEST(Hessenberg, ResidualIsThatOfTheSolution) {
    for (const double albedo : {0.3, 0.99, 0.9999})
        for (const std::size_t steps : {std::size_t{1}, std::size_t{4}, std::size_t{9}}) {
            const Matrix t = reflections(40, albedo, 1);
            const Vector b = random_light(40, 2);
            const Solved s = solve(t, b, steps);
            EXPECT_NEAR(s.small.residual(), residual(t, b, s.x), 1e-9) << albedo << " after " << steps;
            EXPECT_NEAR(s.small.size(), std::sqrt(dot(s.x, s.x)), 1e-9 * s.small.size());
        }
}

/// As many steps as unknowns are enough for any matrix.
TEST(Hessenberg, WholeBasisSolvesExactly) {
    const Matrix t = reflections(12, 0.9999, 3);
    const Vector b = random_light(12, 4);
    EXPECT_LE(residual(t, b, solve(t, b, 12).x), 1e-9);
}

TEST(Hessenberg, SpectralRadiusOfReflections) {
    for (const double albedo : {0.5, 0.9, 0.9999, 1.0})
        EXPECT_NEAR(solve(reflections(40, albedo, 5), random_light(40, 6), 10).small.spectral_radius(), albedo, 1e-6) << albedo;
}

/// Even light in a room of one albedo is reflected as itself: one vector is the whole basis.
TEST(Hessenberg, EvenLightEndsTheBasis) {
    const Solved s = solve(reflections(20, 0.75, 7), Vector(20, 3.0), 5);
    EXPECT_TRUE(s.small.ended());
    EXPECT_EQ(s.small.solution().size(), 1U);
    for (const double x : s.x) EXPECT_NEAR(x, 3.0 / (1 - 0.75), 1e-9);
}

TEST(Hessenberg, NoLightNeedsNothing) {
    const Hessenberg dark(0);
    EXPECT_TRUE(dark.ended());
    EXPECT_EQ(dark.residual(), 0.0);
    EXPECT_EQ(dark.size(), 0.0);
    EXPECT_EQ(dark.spectral_radius(), 0.0);
}

/// Where everything is reflected there is no solution: the residual stays, and nothing becomes infinite.
TEST(Hessenberg, ReflectingAllLeavesTheResidual) {
    const Solved s = solve(reflections(20, 1.0, 8), Vector(20, 1.0), 5);
    EXPECT_NEAR(s.small.spectral_radius(), 1.0, 1e-9);
    for (const double x : s.x) EXPECT_TRUE(std::isfinite(x));
}

}  // namespace
