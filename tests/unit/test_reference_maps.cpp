// Laws of the references of all map parameterisations: they are the truth of the kernel tests and of docs/thesis-results.md.
#include <gtest/gtest.h>

#include "reference/all_maps.h"
#include "reference/random.h"

namespace {

using namespace pencil::ref;

std::vector<Map> all_maps() {
    std::vector<Map> maps = {octahedral_map()};
    for (const NamedMap& named : comparison_maps()) maps.push_back(named.map);
    return maps;
}

class MapReference : public testing::TestWithParam<Map> {};
INSTANTIATE_TEST_SUITE_P(Maps, MapReference, testing::ValuesIn(all_maps()), [](const auto& test) {
    std::string name = test.param.name;
    for (char& c : name) c = c == ' ' || c == '.' ? '_' : c;
    return name;
});

/// Directions at +-epsilon from every place where a map has a seam: the planes between octants and between faces of a cube.
std::vector<std::pair<dvec3, dvec3>> pairs_across_seams(double epsilon) {
    Random random(11);
    std::vector<std::pair<dvec3, dvec3>> pairs;
    for (const dvec3 normal : {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1), dvec3(1, 1, 0), dvec3(1, -1, 0), dvec3(0, 1, 1),
                               dvec3(0, 1, -1), dvec3(1, 0, 1), dvec3(1, 0, -1)}) {
        for (int i = 0; i < 100; ++i) {
            const dvec3 v = random.direction(), n = glm::normalize(normal), on = v - glm::dot(v, n) * n;
            pairs.emplace_back(on + epsilon * n, on - epsilon * n);
        }
    }
    return pairs;
}

TEST_P(MapReference, RoundTrip) {
    const Map& map = GetParam();
    Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const dvec3 v = random.direction();
        const MapPoint p = map.to_point(v);
        ASSERT_TRUE(p.tile >= 0 && p.tile < map.tiles && std::abs(p.uv.x) <= 1.0 && std::abs(p.uv.y) <= 1.0);
        const dvec3 back = glm::normalize(map.to_direction(p.tile, p.uv));
        ASSERT_NEAR(glm::distance(v, back), 0.0, 1e-12)
            << "direction " << v.x << " " << v.y << " " << v.z << " in tile " << p.tile << " at " << p.uv.x << " " << p.uv.y;
    }
}

TEST_P(MapReference, SolidAnglesSumToTheSphere) {
    const Map& map = GetParam();
    for (const int n : {2, 6, 16}) {
        double sum = 0.0;
        for (int tile = 0; tile < map.tiles; ++tile)
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x) sum += texel_solid_angle(map, tile, x, y, n);
        EXPECT_NEAR(sum, 4.0 * pi, map.covers({1.0, 1.0}) ? 1e-10 : 2e-3) << "n " << n;
    }
}

TEST_P(MapReference, SeamsAreContinuous) {
    const Map& map = GetParam();
    const auto rough = [](const dvec3& d) {
        const dvec3 v = glm::normalize(d);
        return std::sin(17.0 * v.x + 1.0) + std::cos(23.0 * v.y) + std::sin(29.0 * v.z + 2.0);
    };
    const auto jump = [&](int n) {
        double most = 0.0;
        for (const auto& [a, b] : pairs_across_seams(1e-11))
            most = std::max(most, std::abs(bilinear(map, rough, a, n) - bilinear(map, rough, b, n)));
        return most;
    };
    if (map.seamless) {
        for (const int n : {2, 5, 16}) EXPECT_LT(jump(n), 1e-8) << "n " << n;
    } else {
        const double coarse = jump(64), fine = jump(256);
        EXPECT_LT(fine, coarse / 8.0) << "the jump falls with the square of the texel, here by 16; it was " << coarse;
    }
}

TEST(MapReferenceLaws, SpecialCasesOfTheSuperquadricFamily) {
    const double infinite = std::numeric_limits<double>::infinity();
    const std::pair<Map, Map> same[] = {{superquadric_map(2.0, false), paraboloid_map()},
                                        {superquadric_map(infinite, true), pyramid_map()}};
    Random random(3);
    for (const auto& [family, map] : same) {
        for (int i = 0; i < 1000; ++i) {
            const dvec3 v = random.direction();
            const MapPoint a = family.to_point(v), b = map.to_point(v);
            ASSERT_EQ(a.tile, b.tile) << map.name;
            ASSERT_NEAR(glm::distance(a.uv, b.uv), 0.0, 1e-12) << map.name;
        }
    }
    const Map cone = superquadric_map(1.0, true);
    for (int i = 0; i < 1000; ++i) {
        dvec3 v = random.direction();
        v.z = std::abs(v.z);
        ASSERT_NEAR(glm::distance(cone.to_point(v).uv, direction_to_oct(v)), 0.0, 1e-12) << "eq. (4.16)";
    }
}

/// Table 6.6: largest over smallest sampling rate (texel area per solid angle).
TEST(MapReferenceLaws, SamplingRatiosOfTable66) {
    const auto rate = [](const Map& map, const dvec2& uv) {
        const double h = 1e-3;
        return 4.0 * h * h / solid_angle(map, 0, uv - h, uv + h, 1);
    };
    EXPECT_NEAR(rate(paraboloid_map(), {0.999 * std::sqrt(0.5), 0.998 * std::sqrt(0.5)}) / rate(paraboloid_map(), {0, 0}), 4.0, 0.02);
    EXPECT_NEAR(rate(cube_map(), {0.999, 0.999}) / rate(cube_map(), {0, 0}), 5.19, 0.02);
    EXPECT_NEAR(rate(octahedral_map(), {0, 0}) / rate(octahedral_map(), {1.0 / 3.0, 1.0 / 3.0}), 5.19, 0.02);
    EXPECT_NEAR(rate(pyramid_map(), {0.999, 0.999}) / rate(pyramid_map(), {0.5, 0}), 8.0, 0.03) << "not in the thesis: 2^3";
}

}  // namespace
