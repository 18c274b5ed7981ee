// Geometry maps against a brute-force ray cast of every texel. No texel may differ except by a documented tie: a ray within rounding of
// an edge, two triangles within rounding of one depth, a plane within rounding of the centre. Ties are counted and must be rare.
#include "kernels/map_comparison.h"

namespace {

using namespace pencil;
using namespace pencil::test;

Comparison compare(const TestScene& scene, const std::vector<float4>& centres, int n) {
    Kernels kernels = make_kernels();
    const DeviceScene on_device(device(), scene.flat);
    const GeometryMaps maps = rasterized(kernels, on_device, centres, n);
    const std::vector<Hit> hits = maps.hits.read();
    Comparison out;
    for (int tile = 0; tile < maps.count; ++tile) compare_tile(scene, xyz(centres[static_cast<std::size_t>(tile)]), hits, tile, n, out);
    EXPECT_EQ(out.wrong, 0) << "of " << out.texels << " texels; first: " << out.first_wrong;
    return out;
}

// Random rays come within 2e-6 of an edge about that often, times a few edges.
constexpr double random_ties = 2e-4;

TEST(RasterizeOctahedral, RandomSoups) {
    for (const int triangles : {1, 3, 40, 257}) {
        for (const int n : {2, 6, 16, 64}) {
            SCOPED_TRACE(std::to_string(triangles) + " triangles, n " + std::to_string(n));
            Random random(static_cast<std::uint32_t>(100 * triangles + n));
            const Comparison c = compare(soup_scene(static_cast<std::uint32_t>(triangles), triangles), random_centres(random, 5, 0.95), n);
            EXPECT_LE(c.ties, 2 + random_ties * c.texels) << "of " << c.texels;
        }
    }
}

TEST(RasterizeOctahedral, CentresOnVerticesEdgesAndFaces) {
    const TestScene scene = soup_scene(11, 60);
    std::vector<float4> centres;
    for (std::size_t i = 0; i < 20; ++i) {
        const ref::Triangle& t = scene.triangles[i];
        centres.push_back(to_float4(t.v0));
        centres.push_back(to_float4(0.5 * (t.v1 + t.v2)));
        centres.push_back(to_float4((t.v0 + t.v1 + t.v2) / 3.0));
        centres.push_back(to_float4(t.v1 + 0.3 * (t.v2 - t.v1)));
    }
    const Comparison c = compare(scene, centres, 32);
    EXPECT_LE(c.ties, 2 + 5.0 * random_ties * c.texels) << "of " << c.texels;
}

TEST(RasterizeOctahedral, CentresNearFaces) {
    const TestScene scene = soup_scene(12, 30);
    std::vector<float4> centres;
    for (const double distance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
        for (std::size_t i = 0; i < 8; ++i) {
            const ref::Triangle& t = scene.triangles[i];
            const dvec3 normal = glm::normalize(glm::cross(t.v1 - t.v0, t.v2 - t.v0));
            centres.push_back(to_float4((t.v0 + t.v1 + t.v2) / 3.0 + distance * normal));
        }
    }
    compare(scene, centres, 32);
}

TEST(RasterizeOctahedral, ClosedBoxHasNoHoles) {
    // Diagonals and box edges pass through texel centres from these symmetric centres: every texel must still show a wall.
    const TestScene scene = box_scene(13);
    std::vector<float4> centres{to_float4(dvec3(0.0)), to_float4({0.25, 0.25, 0.25}), to_float4({0.5, 0, 0}), to_float4({0, -0.5, 0.5})};
    Random random(14);
    for (const float4& c : random_centres(random, 12)) centres.push_back(c);
    for (const int n : {2, 4, 16, 64, 128}) {
        Kernels kernels = make_kernels();
        const DeviceScene on_device(device(), scene.flat);
        const std::vector<Hit> hits = rasterized(kernels, on_device, centres, n).hits.read();
        Comparison c;
        for (int tile = 0; tile < static_cast<int>(centres.size()); ++tile) {
            const auto k = static_cast<std::size_t>(tile);
            compare_tile(scene, xyz(centres[k]), hits, tile, n, c);
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x)
                    ASSERT_GE(hits[atlas_index(tile, x, y, n)].triangle, 0) << "hole at tile " << tile << " texel " << x << " " << y;
        }
        EXPECT_EQ(c.wrong, 0) << "n " << n << ": " << c.first_wrong;
    }
}

TEST(RasterizeOctahedral, SliversAndTinyTriangles) {
    Random random(15);
    std::vector<ref::Triangle> triangles;
    for (int i = 0; i < 50; ++i) {
        const dvec3 a = random.in_box(-0.9, 0.9), along = random.direction() * random.uniform(0.05, 1.0);
        const double width = std::pow(10.0, random.uniform(-5, -1));
        triangles.push_back({ref::as_float(a), ref::as_float(a + along), ref::as_float(a + 0.5 * along + width * random.direction()), i});
        const dvec3 b = random.in_box(-0.9, 0.9);
        const double size = std::pow(10.0, random.uniform(-4, -1));
        triangles.back().plane = 2 * i;
        triangles.push_back(
            {ref::as_float(b), ref::as_float(b + size * random.direction()), ref::as_float(b + size * random.direction()), 2 * i + 1});
    }
    const TestScene scene = make_scene(triangles, 3, 16);
    compare(scene, random_centres(random, 10, 0.9), 64);
}

TEST(RasterizeOctahedral, MeshWithoutGaps) {
    // A finely triangulated sphere around the centres: neighbouring triangles share edges, no ray may slip between them.
    std::vector<ref::Triangle> triangles;
    const int rings = 16;
    const auto at = [&](int i, int j) {
        const double theta = ref::pi * i / rings, phi = ref::pi * (j % (2 * rings)) / rings;
        const double ring = i % rings == 0 ? 0.0 : 0.9 * std::sin(theta);  // the poles are one point each
        return ref::as_float({ring * std::cos(phi), 0.9 * std::cos(theta), ring * std::sin(phi)});
    };
    for (int i = 0; i < rings; ++i) {
        for (int j = 0; j < 2 * rings; ++j) {
            if (i > 0) triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j), 0});
            if (i < rings - 1) triangles.push_back({at(i, j + 1), at(i + 1, j + 1), at(i + 1, j), 0});
        }
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) triangles[i].plane = static_cast<int>(i);
    const TestScene scene = make_scene(triangles, 2, 17);
    Random random(18);
    std::vector<float4> centres = random_centres(random, 6, 0.4);
    centres.push_back(to_float4(dvec3(0.0)));
    const int n = 64;
    Kernels kernels = make_kernels();
    const DeviceScene on_device(device(), scene.flat);
    const std::vector<Hit> hits = rasterized(kernels, on_device, centres, n).hits.read();
    Comparison c;
    for (int tile = 0; tile < static_cast<int>(centres.size()); ++tile) {
        compare_tile(scene, xyz(centres[static_cast<std::size_t>(tile)]), hits, tile, n, c);
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x)
                ASSERT_GE(hits[atlas_index(tile, x, y, n)].triangle, 0) << "gap at tile " << tile << " texel " << x << " " << y;
    }
    EXPECT_EQ(c.wrong, 0) << c.first_wrong;
}

}  // namespace
