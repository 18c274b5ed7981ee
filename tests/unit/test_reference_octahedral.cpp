// Laws of the octahedral reference itself: it is the truth of many kernel tests, so it is checked against geometry, not against code.
#include <gtest/gtest.h>

#include "reference/octahedral_ref.h"
#include "reference/random.h"

namespace {

using namespace pencil::ref;

constexpr double exact = 1e-13;  // double precision, a dozen operations

TEST(OctahedralReference, RoundTripOfRandomDirections) {
    Random random(1);
    for (int i = 0; i < 100000; ++i) {
        const dvec3 v = random.direction();
        const dvec3 back = glm::normalize(oct_to_direction(direction_to_oct(v)));
        ASSERT_NEAR(glm::distance(v, back), 0.0, exact) << "direction " << i << ": " << v.x << " " << v.y << " " << v.z;
    }
}

TEST(OctahedralReference, RoundTripOfAxesAndSigns) {
    for (int code = 0; code < 27; ++code) {
        const dvec3 v(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
        if (l1_norm(v) == 0.0) continue;
        const dvec3 back = oct_to_direction(direction_to_oct(v)), unit = v / l1_norm(v);
        EXPECT_NEAR(glm::distance(unit, back), 0.0, exact)
            << v.x << " " << v.y << " " << v.z << " -> " << back.x << " " << back.y << " " << back.z;
        EXPECT_NEAR(l1_norm(back), 1.0, exact);
    }
}

TEST(OctahedralReference, EveryTexelCentreReturnsToItsTexel) {
    for (const int n : {1, 2, 3, 7, 16, 33, 64}) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                const dvec2 uv = direction_to_oct(texel_direction(x, y, n));
                ASSERT_NEAR(glm::distance(uv, texel_centre(x, y, n)), 0.0, exact) << "n " << n << " texel " << x << " " << y;
            }
        }
    }
}

TEST(OctahedralReference, KnownCorners) {
    EXPECT_EQ(direction_to_oct({0, 0, 1}), dvec2(0, 0));
    EXPECT_EQ(direction_to_oct({1, 0, 0}), dvec2(1, 0));
    EXPECT_EQ(direction_to_oct({0, -1, 0}), dvec2(0, -1));
    EXPECT_EQ(direction_to_oct({0, 0, -1}), dvec2(1, 1));  // with S = +1 of a positive zero
    EXPECT_EQ(direction_to_oct({-0.0, -0.0, -1}), dvec2(-1, -1));
    EXPECT_EQ(direction_to_oct({1, 1, 1}), dvec2(1.0 / 3.0, 1.0 / 3.0));
    EXPECT_NEAR(direction_to_oct({1, 1, -1}).x, 2.0 / 3.0, exact);  // the flip (4.17) of (1/3, 1/3)
}

TEST(OctahedralReference, SolidAnglesSumToTheSphere) {
    for (const int n : {1, 2, 3, 5, 8, 16, 31, 64, 128}) {
        double sum = 0.0;
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) sum += texel_solid_angle(x, y, n);
        EXPECT_NEAR(sum, 4.0 * pi, 1e-10) << "n " << n;
    }
}

TEST(OctahedralReference, SolidAngleIsDensityTimesArea) {
    const int n = 256;
    const double texel_area = 4.0 / (n * n);
    for (int y = 0; y < n; y += 5) {
        for (int x = 0; x < n; x += 3) {
            const double density = solid_angle_density(texel_direction(x, y, n));
            // On the border of two octants the density has a kink: half a texel is seen with either slope.
            ASSERT_NEAR(texel_solid_angle(x, y, n) / texel_area, density, 0.02 * density) << x << " " << y;
        }
    }
}

TEST(OctahedralReference, SamplingRatioOfTable66) {
    const int n = 512;
    double low = 1e9, high = 0.0;
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const double w = texel_solid_angle(x, y, n);
            low = std::min(low, w);
            high = std::max(high, w);
        }
    }
    EXPECT_NEAR(high / low, 5.19, 0.08) << "thesis table 6.6";
    EXPECT_NEAR(solid_angle_density({1, 1, 1}) / solid_angle_density({0, 0, 1}), 3.0 * std::sqrt(3.0), exact);
}

TEST(OctahedralReference, FoldIsTheTexelAcrossTheSeam) {
    for (const int n : {1, 2, 3, 8, 64}) {
        for (int i = 0; i < n; ++i) {
            // The point on the border in the middle of texel i's side; the other copy of the same direction is at the mirrored place.
            const double u = (2.0 * i + 1.0) / n - 1.0;
            EXPECT_NEAR(glm::distance(oct_to_direction({1.0, u}), oct_to_direction({1.0, -u})), 0.0, exact);
            EXPECT_NEAR(glm::distance(oct_to_direction({u, -1.0}), oct_to_direction({-u, -1.0})), 0.0, exact);
            const Texel left = fold(-1, i, n), right = fold(n, i, n), top = fold(i, -1, n), bottom = fold(i, n, n);
            EXPECT_EQ(left.x, 0);
            EXPECT_EQ(left.y, n - 1 - i);
            EXPECT_EQ(right.x, n - 1);
            EXPECT_EQ(right.y, n - 1 - i);
            EXPECT_EQ(top.x, n - 1 - i);
            EXPECT_EQ(top.y, 0);
            EXPECT_EQ(bottom.x, n - 1 - i);
            EXPECT_EQ(bottom.y, n - 1);
        }
        const Texel corner = fold(-1, n, n);
        EXPECT_EQ(corner.x, n - 1);
        EXPECT_EQ(corner.y, 0);
    }
}

TEST(OctahedralReference, BilinearLookUpIsContinuousAcrossSeamsAndCorners) {
    const int n = 16;
    Random random(2);
    std::vector<double> tile(static_cast<std::size_t>(n) * n);
    for (double& texel : tile) texel = random.uniform();
    const auto texel = [&](int x, int y) { return tile[static_cast<std::size_t>(y) * n + static_cast<std::size_t>(x)]; };
    for (int i = 0; i <= 400; ++i) {
        const double s = -1.0 + i / 200.0;
        EXPECT_NEAR(bilinear(texel, {1.0, s}, n), bilinear(texel, {1.0, -s}, n), exact) << "right side at " << s;
        EXPECT_NEAR(bilinear(texel, {-1.0, s}, n), bilinear(texel, {-1.0, -s}, n), exact) << "left side at " << s;
        EXPECT_NEAR(bilinear(texel, {s, 1.0}, n), bilinear(texel, {-s, 1.0}, n), exact) << "lower side at " << s;
        EXPECT_NEAR(bilinear(texel, {s, -1.0}, n), bilinear(texel, {-s, -1.0}, n), exact) << "upper side at " << s;
    }
    const double pole = bilinear(texel, {1.0, 1.0}, n);
    for (const dvec2& corner : {dvec2(-1, -1), dvec2(-1, 1), dvec2(1, -1)}) EXPECT_NEAR(bilinear(texel, corner, n), pole, exact);
}

TEST(OctahedralReference, AntipodalTexelIsAnInvolution) {
    for (const int n : {2, 4, 16, 64}) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                const Texel t = antipodal_texel(x, y, n);
                const dvec3 v = glm::normalize(texel_direction(x, y, n)), w = glm::normalize(texel_direction(t.x, t.y, n));
                ASSERT_NEAR(glm::distance(v, -w), 0.0, exact) << "n " << n << " texel " << x << " " << y;
                const Texel back = antipodal_texel(t.x, t.y, n);
                ASSERT_TRUE(back.x == x && back.y == y) << "n " << n << " texel " << x << " " << y;
            }
        }
    }
}

}  // namespace
