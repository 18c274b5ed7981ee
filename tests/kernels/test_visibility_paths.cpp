// The other two ways to make geometry maps, by clusters and by rays, against the same brute-force ray cast as the rasteriser, and all three
// against each other over scenes that brute force is too slow for.
#include "kernels/map_comparison.h"
#include "visibility/geometry_maps.h"
#include "visibility/rasterize_clusters.h"
#include "visibility/trace_maps.h"

namespace {

using namespace pencil;
using namespace pencil::test;

using MakeMaps = void (*)(Kernels&, const DeviceScene&, GeometryMaps&, int, int);

struct Path {
    const char* name;
    MakeMaps make;
};
void PrintTo(const Path& path, std::ostream* out) { *out << path.name; }

class VisibilityPaths : public testing::TestWithParam<Path> {};
INSTANTIATE_TEST_SUITE_P(Of, VisibilityPaths,
                         testing::Values(Path{"Rasterize", rasterize_octahedral}, Path{"Clusters", rasterize_clusters},
                                         Path{"Trace", trace_maps}),
                         [](const auto& path) { return path.param.name; });

DeviceScene prepared_scene(const TestScene& scene) {
    return DeviceScene(device(), scene.flat, build_bvh(scene.flat.triangles), cluster_triangles(scene.flat.triangles));
}

std::vector<Hit> made(MakeMaps make, Kernels& kernels, const DeviceScene& scene, const std::vector<float4>& centres, int n) {
    GeometryMaps maps(device(), centres, n, "test");
    make(kernels, scene, maps, 0, maps.count);
    return maps.hits.read();
}

Comparison compare(MakeMaps make, const TestScene& scene, const std::vector<float4>& centres, int n) {
    Kernels kernels = make_kernels();
    const std::vector<Hit> hits = made(make, kernels, prepared_scene(scene), centres, n);
    Comparison out;
    for (std::size_t tile = 0; tile < centres.size(); ++tile) compare_tile(scene, xyz(centres[tile]), hits, static_cast<int>(tile), n, out);
    EXPECT_EQ(out.wrong, 0) << "of " << out.texels << " texels; first: " << out.first_wrong;
    return out;
}

TEST_P(VisibilityPaths, RandomSoups) {
    for (const int triangles : {1, 3, 40, 600}) {
        for (const int n : {8, 16, 64}) {
            SCOPED_TRACE(std::to_string(triangles) + " triangles, n " + std::to_string(n));
            Random random(static_cast<std::uint32_t>(100 * triangles + n));
            const TestScene scene = soup_scene(static_cast<std::uint32_t>(triangles), triangles);
            const Comparison c = compare(GetParam().make, scene, random_centres(random, 3, 0.95), n);
            EXPECT_LE(c.ties, 2 + 2e-4 * c.texels) << "of " << c.texels;
        }
    }
}

TEST_P(VisibilityPaths, CentresOnAndNearTriangles) {
    const TestScene scene = soup_scene(12, 60);
    std::vector<float4> centres;
    for (std::size_t i = 0; i < 12; ++i) {
        const ref::Triangle& t = scene.triangles[i];
        const dvec3 normal = glm::normalize(glm::cross(t.v1 - t.v0, t.v2 - t.v0)), middle = (t.v0 + t.v1 + t.v2) / 3.0;
        for (const dvec3& p : {t.v0, 0.5 * (t.v1 + t.v2), middle, middle + 1e-3 * normal, middle + 1e-5 * normal, middle + 1e-7 * normal})
            centres.push_back(to_float4(p));
    }
    compare(GetParam().make, scene, centres, 16);
}

TEST_P(VisibilityPaths, ClosedBoxHasNoHoles) {
    // From these centres diagonals and box edges pass through texel centres.
    const TestScene scene = box_scene(13);
    const std::vector<float4> centres{to_float4(dvec3(0.0)), to_float4({0.25, 0.25, 0.25}), to_float4({0.5, 0, 0}),
                                      to_float4({0, -0.5, 0.5})};
    Kernels kernels = make_kernels();
    for (const int n : {8, 16, 64}) {
        const std::vector<Hit> hits = made(GetParam().make, kernels, prepared_scene(scene), centres, n);
        for (int tile = 0; tile < static_cast<int>(centres.size()); ++tile)
            for (int i = 0; i < n * n; ++i)
                ASSERT_GE(hits[atlas_index(tile, i % n, i / n, n)].triangle, 0) << "hole at tile " << tile << " texel " << i;
    }
}

TEST_P(VisibilityPaths, LowerIndexWinsATie) {
    // Every triangle twice: of two that are the same to the last bit the first must be shown.
    Random random(21);
    std::vector<ref::Triangle> triangles = ref::triangle_soup(random, 100);
    const std::vector<ref::Triangle> again = triangles;
    triangles.insert(triangles.end(), again.begin(), again.end());
    const TestScene scene = make_scene(triangles, 3, 22);
    Kernels kernels = make_kernels();
    const std::vector<float4> centres = random_centres(random, 5);
    int shown = 0;
    for (const Hit& hit : made(GetParam().make, kernels, prepared_scene(scene), centres, 32)) {
        ASSERT_LT(hit.triangle, 100);
        shown += hit.triangle >= 0 ? 1 : 0;
    }
    EXPECT_GT(shown, 1000);
}

TEST_P(VisibilityPaths, RangesOfTilesLeaveOthersAlone) {
    Random random(19);
    const TestScene scene = soup_scene(20, 30);
    const std::vector<float4> centres = random_centres(random, 7);
    Kernels kernels = make_kernels();
    const DeviceScene on_device = prepared_scene(scene);
    const int n = 8;
    const std::vector<Hit> all = made(GetParam().make, kernels, on_device, centres, n);
    GeometryMaps maps(device(), centres, n, "test");
    maps.hits.write(std::vector<Hit>(maps.hits.size(), Hit{-7, -7.0F}));
    GetParam().make(kernels, on_device, maps, 2, 3);
    const std::vector<Hit> part = maps.hits.read();
    const std::size_t tile = PENCIL_TILE_TEXELS(n);
    for (std::size_t i = 0; i < part.size(); ++i) {
        const bool inside = i >= 2 * tile && i < 5 * tile;
        ASSERT_EQ(part[i].triangle, inside ? all[i].triangle : -7) << "texel " << i;
        ASSERT_EQ(part[i].disparity, inside ? all[i].disparity : -7.0F) << "texel " << i;
    }
}

TEST_P(VisibilityPaths, AgreesWithTheRasteriserOverManyTriangles) {
    // Clusters and groups of clusters, some behind walls. Texels that differ must be ties.
    const TestScene scene = room_scene(31, 6000);
    Random random(32);
    const std::vector<float4> centres = random_centres(random, 6);
    Kernels kernels = make_kernels();
    const DeviceScene on_device = prepared_scene(scene);
    for (const int n : {8, 16, 64}) {
        const std::vector<Hit> hits = made(GetParam().make, kernels, on_device, centres, n);
        const std::vector<Hit> expected = made(rasterize_octahedral, kernels, on_device, centres, n);
        int different = 0;
        for (int tile = 0; tile < static_cast<int>(centres.size()); ++tile)
            for (int i = 0; i < n * n; ++i) {
                const std::size_t at = atlas_index(tile, i % n, i / n, n);
                if (hits[at].triangle == expected[at].triangle) continue;
                ++different;
                EXPECT_TRUE(ref::is_plausible(scene.triangles, xyz(centres[static_cast<std::size_t>(tile)]),
                                              ref::texel_direction(i % n, i / n, n), hits[at].triangle))
                    << "tile " << tile << " texel " << i << " of " << n << "x" << n;
            }
        EXPECT_LE(different, 2 + 1e-3 * static_cast<double>(hits.size())) << "n " << n;
    }
}

TEST(GeometryMaps, AreMadeByWhatIsPrepared) {
    // Without preparation only the rasteriser remains; with it another path is chosen over many triangles, to the same end.
    const TestScene scene = room_scene(33, 6000);
    Random random(34);
    const std::vector<float4> centres = random_centres(random, 40);
    const DeviceScene plain(device(), scene.flat), prepared = prepared_scene(scene);
    Kernels kernels = make_kernels();
    const auto launches = [&](const char* name) {
        const auto times = device()->launch_times();
        const auto found = times.find(name);
        return found == times.end() ? 0 : found->second.launches;
    };
    const int drawn = launches("rasterize octahedral maps"), traced = launches("trace geometry maps");
    const std::vector<Hit> by_drawing = made(make_geometry_maps, kernels, plain, centres, 8);
    EXPECT_EQ(launches("rasterize octahedral maps"), drawn + 1);
    const std::vector<Hit> by_rays = made(make_geometry_maps, kernels, prepared, centres, 8);
    EXPECT_EQ(launches("trace geometry maps"), traced + 1);
    std::size_t different = 0;
    for (std::size_t i = 0; i < by_rays.size(); ++i) different += by_rays[i].triangle != by_drawing[i].triangle ? 1 : 0;
    EXPECT_LE(static_cast<double>(different), 2 + 1e-3 * static_cast<double>(by_rays.size()));
}

}  // namespace
