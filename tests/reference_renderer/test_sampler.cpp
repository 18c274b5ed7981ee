// Sobol' pairs stay (0,2)-sequences under scrambling; filters are sampled without bias.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "reference/filter_sampler.h"
#include "reference/sampler.h"
#include "scene/filter_value.h"

namespace {

using namespace pencil;
using Kind = ReconstructionFilter::Kind;

/// Of the 2^m points, each box of 2^-k x 2^(k-m) must hold one.
void expect_net(const std::vector<glm::dvec2>& points, int m) {
    for (int k = 0; k <= m; ++k) {
        std::vector<int> hits(points.size());
        for (const glm::dvec2& p : points) {
            ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
            const auto column = static_cast<std::size_t>(std::ldexp(p.x, k)), row = static_cast<std::size_t>(std::ldexp(p.y, m - k));
            ++hits[(column << (m - k)) + row];
        }
        for (const int count : hits) ASSERT_EQ(count, 1) << "boxes of 2^-" << k << " by 2^-" << m - k;
    }
}

TEST(Sampler, EveryPairIsAZeroTwoSequence) {
    constexpr int m = 8;
    for (const std::uint64_t seed : {0ULL, 1ULL, 0xdeadbeefcafeULL}) {
        for (std::uint32_t start : {0U, 256U, 77U * 256U}) {  // any aligned block of a sequence is a net
            std::vector<std::vector<glm::dvec2>> pairs(6);
            for (std::uint32_t i = 0; i < (1U << m); ++i) {
                Sampler sampler(seed, start + i);
                for (auto& pair : pairs) pair.push_back(sampler.next_2d());
            }
            for (const auto& pair : pairs) expect_net(pair, m);
        }
    }
}

TEST(Sampler, PairsOfOneSampleAreUncorrelated) {
    constexpr int n = 4096;
    double sum = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
        Sampler sampler(5, i);
        const glm::dvec2 a = sampler.next_2d(), b = sampler.next_2d();
        sum += 12 * (a.x - 0.5) * (b.x - 0.5);
    }
    EXPECT_LT(std::abs(sum / n), 4 / std::sqrt(static_cast<double>(n)));
}

TEST(Sampler, OneDimensionIsUniform) {
    constexpr int n = 65536, bins = 64;
    std::vector<int> hits(bins);
    for (std::uint32_t i = 0; i < n; ++i) ++hits[static_cast<std::size_t>(Sampler(9, i).next_1d() * bins)];
    double chi_square = 0;
    for (const int count : hits) chi_square += std::pow(count - n / bins, 2) * bins / n;
    EXPECT_LT(chi_square, 63 + 4 * std::sqrt(2 * 63.0));
}

ReconstructionFilter filter(Kind kind, double radius) {
    ReconstructionFilter f;
    f.kind = kind;
    f.radius = radius;
    return f;
}

/// Mean of weight * g(offset) is the integral of filter * g over that of the filter, on the part of the filter that is used.
TEST(FilterSampler, ReproducesTheFilter) {
    const auto g = [](double x) { return 1.5 + std::sin(1.3 * x) + 0.4 * x * x; };
    for (const ReconstructionFilter& f :
         {filter(Kind::box, 0.5), filter(Kind::box, 0.8), filter(Kind::tent, 1.0), filter(Kind::gaussian, 2.0), filter(Kind::mitchell, 2.0),
          filter(Kind::catmullrom, 2.0), filter(Kind::lanczos, 3.0)}) {
        const FilterSampler sampler(f);
        for (const auto& [low, high] : {std::pair{-100.5, 100.5}, {-0.5, 4.5}, {-1.5, 0.5}, {-0.5, 0.5}}) {
            constexpr int steps = 200000;
            double sampled = 0, weights = 0, weighted = 0, plain = 0;
            const double from = std::max(low, -f.radius), to = std::min(high, f.radius);
            for (int i = 0; i < steps; ++i) {
                const double u = (i + 0.5) / steps;
                const FilterSampler::Sample s = sampler.sample(sampler.range(low, high), u);
                ASSERT_TRUE(s.offset >= low && s.offset <= high);
                sampled += s.weight * g(s.offset) / steps;
                weights += static_cast<double>(s.weight) / steps;
                const double x = from + u * (to - from);
                weighted += filter_value(f, x) * g(x);
                plain += filter_value(f, x);
            }
            const std::string what = "filter " + std::to_string(static_cast<int>(f.kind)) + " on " + std::to_string(low);
            EXPECT_NEAR(weights, 1, 1e-4) << what;
            EXPECT_NEAR(sampled, weighted / plain, 1e-3 * std::abs(weighted / plain)) << what;
        }
    }
}

}  // namespace
