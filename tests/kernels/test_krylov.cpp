// x = b + T x by GMRES on the device, against the exact solution: stiff, dark and endless.
#include "kernels/surface_test.h"
#include "surface/krylov.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// T of a room of two parts that see themselves and each other: rows of sum `albedo`, on the host. The light of each channel is reflected by
/// its own albedo.
struct TwoParts {
    dvec3 albedo;
    double across;  // share of its light that a part takes from the other
    int count;

    Transport transport() const {
        return [this](const Buffer<float4>& source, Buffer<float4>& target) {
            const std::vector<float4> in = source.read();
            dvec3 mean[2] = {dvec3(0), dvec3(0)};
            const int half = count / 2;
            for (int i = 0; i < count; ++i)
                mean[i < half ? 0 : 1] += xyz(in[static_cast<std::size_t>(i)]) / static_cast<double>(i < half ? half : count - half);
            std::vector<float4> out;
            for (int i = 0; i < count; ++i) {
                const int own = i < half ? 0 : 1;
                out.push_back(to_float4(albedo * ((1 - across) * mean[own] + across * mean[1 - own])));
            }
            target.write(out);
        };
    }
};

struct Solved {
    std::vector<float4> x;
    KrylovReport report;
};

Solved solve(const TwoParts& room, const std::vector<float4>& b, double tolerance = 1e-4) {
    Kernels kernels = make_kernels();
    Buffer<float4> total(device(), std::vector<float4>(b.size(), float4(0)), "total");
    const KrylovReport report =
        solve_reflections(kernels, room.transport(), Buffer<float4>(device(), b, "b"), room.count, tolerance, 200, total);
    return {total.read(), report};
}

/// Means of the parts: m = (I - a S)^-1 of those of b, S symmetric with eigenvalues 1 and 1 - 2 across; x = b + what these reflect.
dvec3 exact(const TwoParts& room, const std::vector<float4>& b, int i) {
    const int half = room.count / 2;
    dvec3 mean[2] = {dvec3(0), dvec3(0)};
    for (int k = 0; k < room.count; ++k)
        mean[k < half ? 0 : 1] += xyz(b[static_cast<std::size_t>(k)]) / static_cast<double>(k < half ? half : room.count - half);
    const dvec3 even = 0.5 * (mean[0] + mean[1]), odd = 0.5 * (mean[0] - mean[1]);
    const dvec3 sum_even = room.albedo * even / (1.0 - room.albedo), weak = room.albedo * (1 - 2 * room.across),
                sum_odd = weak * odd / (1.0 - weak);
    return xyz(b[static_cast<std::size_t>(i)]) + sum_even + (i < half ? 1.0 : -1.0) * sum_odd;
}

TEST(Krylov, SolvesStiffRooms) {
    for (const double albedo : {0.5, 0.99, 0.999, 0.9999}) {
        const double as_float = static_cast<double>(static_cast<float>(albedo));
        const TwoParts room{dvec3(as_float, 0.5, 0.0), 1e-3, 100};
        Random random(1);
        const std::vector<float4> b = random_irradiance(random, 100);
        const Solved s = solve(room, b);
        for (int i = 0; i < 100; ++i)
            for (int c = 0; c < 3; ++c) {
                const double expected = exact(room, b, i)[c];
                ASSERT_NEAR(s.x[static_cast<std::size_t>(i)][c] / expected, 1, 2e-3) << albedo << ", pencil " << i << ", channel " << c;
            }
        EXPECT_LE(s.report.applications, 20) << albedo;
        EXPECT_NEAR(s.report.spectral_radius.x, as_float, 1e-5);
        EXPECT_FALSE(has_no_sum(s.report.spectral_radius));
        EXPECT_LE(s.report.error.x, 2e-3);
    }
}

/// Light of one colour: the others hold what rounding leaves, whose inverse is beyond float.
TEST(Krylov, ChannelsWithoutLightStayOut) {
    for (const float nothing : {0.0F, 1e-35F, 1e-42F}) {
        const TwoParts room{dvec3(0.999), 1e-3, 100};
        Random random(2);
        std::vector<float4> b = random_irradiance(random, 100);
        for (float4& v : b) v.y = v.z = nothing;
        const Solved s = solve(room, b);
        for (int i = 0; i < 100; ++i) {
            const float4& x = s.x[static_cast<std::size_t>(i)];
            ASSERT_NEAR(x.x / exact(room, b, i).x, 1, 2e-3) << nothing << ", pencil " << i;
            ASSERT_TRUE(x.y >= 0 && x.y <= 1e-30F && x.z >= 0 && x.z <= 1e-30F) << nothing << ", pencil " << i << ": " << x.y;
        }
        EXPECT_LE(s.report.error.x, 2e-3);
        EXPECT_EQ(s.report.error.y, 0);
    }
}

TEST(Krylov, WhatHasNoSumIsNamedAndAddsNothing) {
    const TwoParts room{dvec3(1.0, 0.5, 0.25), 0.1, 60};
    const Solved s = solve(room, std::vector<float4>(60, float4(1, 1, 1, 0)));
    EXPECT_TRUE(has_no_sum(s.report.spectral_radius));
    for (const float4& x : s.x) {
        ASSERT_EQ(x.x, 0.0F);
        ASSERT_NEAR(x.y, 2.0F, 1e-4F);
        ASSERT_NEAR(x.z, 4.0F / 3, 1e-4F);
    }
}

TEST(Krylov, DarknessNeedsNoApplications) {
    const Solved s = solve({dvec3(0.9), 0.1, 10}, std::vector<float4>(10, float4(0)));
    EXPECT_LE(s.report.applications, 1);
    for (const float4& x : s.x) EXPECT_EQ(x, float4(0));
}

TEST(Krylov, TheSameBitsEachTime) {
    Random random(5);
    const std::vector<float4> b = random_irradiance(random, 333);
    const TwoParts room{dvec3(0.999, 0.9, 0.5), 0.01, 333};
    EXPECT_EQ(solve(room, b).x, solve(room, b).x);
}

}  // namespace
