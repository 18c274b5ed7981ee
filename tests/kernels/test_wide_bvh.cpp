// The wide hierarchy: it holds what the binary one holds, and rays that go through it alone, or in narrow packets, meet what packets meet there,
// to the last bit where they compute the same.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "cl/device_profile.h"
#include "film/light_surfels.h"
#include "film/trace_film.h"
#include "kernels/film_test.h"
#include "kernels/light_test.h"
#include "kernels/surface_test.h"
#include "line/find_viewers.h"
#include "pencils/build_wide_bvh.h"
#include "pencils/film_filter.h"
#include "reference/tolerances.h"
#include "surface/sample_lights.h"
#include "surface/trace_hemispheres.h"
#include "util/environment.h"

namespace {

using namespace pencil;
using namespace pencil::test;

DeviceScene scene_of(const TestScene& scene, bool wide) { return DeviceScene(device(), scene.flat, build_hierarchy(scene.flat, wide)); }
Kernels kernels_of(bool wide) {
    Features features;
    features.film_samples = 4;
    features.wide_bvh = wide;
    return Kernels(device(), features);
}

/// Triangles below a node, each of which its box holds; counts the nodes of the longest path.
int collect(const WideBvh& bvh, const FlatScene& flat, int index, std::vector<int>& found) {
    const WideNode& node = bvh.nodes[static_cast<std::size_t>(index)];
    int levels = 0;
    for (int k = 0; k < WIDE_CHILDREN; ++k) {
        if (!(node.low[0][k] <= node.high[0][k])) continue;
        std::vector<int> below;
        if (node.child[k] >= 0)
            levels = std::max(levels, collect(bvh, flat, node.child[k], below));
        else
            for (const int t : bvh.leaves[static_cast<std::size_t>(~node.child[k])].triangle)
                if (t >= 0) below.push_back(t);
        EXPECT_FALSE(below.empty());
        for (const int t : below) {
            const Triangle& triangle = flat.triangles[static_cast<std::size_t>(t)];
            for (const float4& v : {triangle.v0, triangle.v1, triangle.v2})
                for (int axis = 0; axis < 3; ++axis)
                    EXPECT_TRUE(node.low[axis][k] < v[axis] && v[axis] < node.high[axis][k]) << "triangle " << t << ", axis " << axis;
        }
        found.insert(found.end(), below.begin(), below.end());
    }
    return levels + 1;
}

TEST(WideBvh, HoldsEveryTriangleOnce) {
    for (const int things : {0, 1, 40, 3000}) {
        const TestScene scene = things > 0 ? room_scene(5, things) : soup_scene(3, 3);
        const WideBvh bvh = build_wide_bvh(scene.flat.triangles, scene.flat.planes);
        std::vector<int> found;
        EXPECT_EQ(collect(bvh, scene.flat, 0, found), bvh.levels);
        EXPECT_LE(bvh.levels, WIDE_MOST_LEVELS);
        std::sort(found.begin(), found.end());
        ASSERT_EQ(found.size(), scene.flat.triangles.size());
        for (std::size_t i = 0; i < found.size(); ++i) ASSERT_EQ(found[i], static_cast<int>(i));
    }
}

TEST(WideBvh, CoincidentTrianglesEndInLeavesOfFour) {
    TestScene scene = soup_scene(3, 1);
    scene.flat.triangles.resize(1000, scene.flat.triangles[0]);
    const WideBvh bvh = build_wide_bvh(scene.flat.triangles, scene.flat.planes);
    std::vector<int> found;
    EXPECT_LE(collect(bvh, scene.flat, 0, found), WIDE_MOST_LEVELS);
    EXPECT_EQ(found.size(), 1000U);
}

TEST(WideBvh, HemispheresSeeWhatPacketsSee) {
    for (const int things : {0, 1, 40, 3000}) {
        const TestScene scene = room_scene(static_cast<std::uint32_t>(things) + 3, things);
        std::vector<SurfacePencil> placed = random_pencils(5, 37);
        for (SurfacePencil& p : placed) p.plane = Random(static_cast<std::uint32_t>(p.key)).index(7) - 1;
        std::vector<std::vector<float>> seen;
        for (const bool wide : {false, true}) {
            Kernels kernels = kernels_of(wide);
            SurfacePencils pencils(device(), 37, 8);
            pencils.data.write(placed);
            pencils.count = 37;
            Surfels surfels(device(), 37 * 64, "surfels");
            trace_hemispheres(kernels, scene_of(scene, wide), pencils, 0, 37, {7}, surfels);
            seen.push_back(surfels.data.read());
        }
        int differ = 0;
        for (std::size_t i = 0; i < seen[0].size(); ++i) differ += std::memcmp(&seen[0][i], &seen[1][i], sizeof(float)) != 0 ? 1 : 0;
        EXPECT_EQ(differ, 0) << things << " things";
    }
}

/// Packets that go alone, and narrow ones.
TEST(WideBvh, TheFilmSeesWhatPacketsSee) {
    for (const double tan_half : {0.7, 0.02}) {
        const TestCamera view = make_camera({0.1, -0.2, 0.6}, {0.1, 0.1, -1}, {0, 1, 0}, tan_half, 16, 12);
        TestScene scene = room_scene(8, 3000);
        scene.flat.to_film = view.to_film;
        const std::vector<glm::vec2> offsets = film_sample_offsets(4, 5);
        std::vector<std::vector<Hit>> seen;
        for (const bool wide : {false, true}) {
            Kernels kernels = kernels_of(wide);
            Buffer<Hit> hits(device(), offsets.size() * 16 * 12, "hits");
            trace_film(kernels, scene_of(scene, wide), view.camera, Buffer<glm::vec2>(device(), offsets, "offsets"), 4, 0, 12, hits,
                       "film hits");
            seen.push_back(hits.read());
        }
        for (std::size_t i = 0; i < seen[0].size(); ++i) {
            ASSERT_EQ(seen[0][i].triangle, seen[1][i].triangle) << i;
            ASSERT_EQ(seen[0][i].disparity, seen[1][i].disparity) << i;
        }
    }
}

/// Rays of a lens go through the nearest triangles alone, each from its own place.
TEST(WideBvh, LanesMeetWhatPacketsMeet) {
    const TestCamera view = make_camera({0.1, -0.2, 0.6}, {0.1, 0.1, -1}, {0, 1, 0}, 0.7, 16, 12);
    const TestScene scene = room_scene(8, 3000);
    std::vector<glm::vec2> offsets = film_sample_offsets(4, 5);
    for (const glm::vec2& on_lens : {glm::vec2(0.5F, 0.1F), glm::vec2(-0.3F, 0.4F), glm::vec2(0, -0.7F), glm::vec2(0)})
        offsets.push_back(on_lens);
    std::vector<std::vector<Hit>> seen;
    for (const bool wide : {false, true}) {
        Features features = kernels_of(wide).features();
        features.wide_camera = true;
        Kernels kernels(device(), features);
        Camera camera = view.camera;
        camera.lens_x = float4(0.05F, 0, 0, 0);
        camera.lens_y = float4(0, 0.05F, 0, 0);
        Buffer<Hit> hits(device(), 4 * 16 * 12, "hits");
        trace_film(kernels, scene_of(scene, wide), camera, Buffer<glm::vec2>(device(), offsets, "offsets"), 4, 0, 12, hits, "film hits");
        seen.push_back(hits.read());
    }
    int differ = 0;
    for (std::size_t i = 0; i < seen[0].size(); ++i) {
        if (seen[0][i].triangle != seen[1][i].triangle) {
            ++differ;
            continue;
        }
        if (seen[0][i].triangle < 0) continue;
        ASSERT_NEAR(1.0 / seen[0][i].disparity, 1.0 / seen[1][i].disparity, 1e-5) << i;
    }
    EXPECT_EQ(seen[0].size(), 768U);
    EXPECT_LE(differ, 1) << "a ray along an edge may differ";
}

/// Nothing is met, and nothing hangs, where there is nothing or rays have no place.
TEST(WideBvh, EmptyScenesAndRaysWithoutPlace) {
    TestScene scene = box_scene(1);
    for (const bool empty : {false, true}) {
        std::vector<SurfacePencil> placed = random_pencils(5, 3);
        if (empty)
            scene.flat.triangles.clear();
        else
            for (SurfacePencil& p : placed) p.position.x = std::nanf("");
        Kernels kernels = kernels_of(true);
        SurfacePencils pencils(device(), 3, 4);
        pencils.data.write(placed);
        pencils.count = 3;
        Surfels surfels(device(), 48, "surfels");
        trace_hemispheres(kernels, scene_of(scene, true), pencils, 0, 3, {7}, surfels);
        const HostSurfels seen(surfels);
        for (int i = 0; i < 48; ++i) EXPECT_EQ(seen.plane(i), -1);
    }
}

TEST(WideBvh, ManyTrianglesOnPacketsWantIt) {
    if (!environment("PENCIL_WIDE_BVH").empty()) GTEST_SKIP() << "PENCIL_WIDE_BVH decides";
    EXPECT_TRUE(wants_wide_bvh(16, 1000000));
    EXPECT_FALSE(wants_wide_bvh(16, 1000));
    EXPECT_FALSE(wants_wide_bvh(1, 1000000)) << "a GPU's rays go alone anyway";
}

/// Rays from places of their own, until each has met something.
TEST(WideBvh, LanesAreStoppedAsPacketsAre) {
    const TestScene scene = room_scene(9, 400);
    Random random(3);
    MadeSurfels surfels(200);
    for (int i = 0; i < 200; ++i) surfels.place(i, random.in_box(-0.6, 0.6), random.direction(), 1 << 20, dvec3(0.5));
    std::vector<float4> centres;
    for (int i = 0; i < 21; ++i) centres.push_back(to_float4(random.in_box(-0.7, 0.7)));
    std::vector<std::vector<int>> seen;
    for (const bool wide : {false, true}) {
        Kernels kernels = kernels_of(wide);
        seen.push_back(find_viewers(kernels, scene_of(scene, wide), surfels.on_device(), Buffer<float4>(device(), centres, "centres")));
    }
    EXPECT_GT(*std::max_element(seen[0].begin(), seen[0].end()), 8);
    EXPECT_EQ(seen[0], seen[1]);
}

/// Segments from light samples, in packets that are wide and narrow.
TEST(WideBvh, LightReachesWhatItReachesInPackets) {
    std::vector<std::vector<float>> lit;
    for (const bool wide : {false, true}) {
        RayRoom room(111, 400, 24, 700, wide);
        Buffer<float> outgoing(device(), static_cast<std::size_t>(room.surfels.capacity) * 3, "outgoing");
        outgoing.fill_zero();
        light_surfels(room.kernels, room.on_device, room.surfels, room.lights, outgoing, "test");
        lit.push_back(outgoing.read());
        outgoing.fill_zero();
        sample_lights(room.kernels, room.on_device, room.surfels, room.lights, 1, 6, 9, outgoing);
        const std::vector<float> sampled = outgoing.read();
        lit.back().insert(lit.back().end(), sampled.begin(), sampled.end());
    }
    int lighted = 0;
    for (std::size_t i = 0; i < lit[0].size(); ++i) {
        ASSERT_EQ(lit[0][i], lit[1][i]) << i;
        lighted += lit[0][i] > 0.0F ? 1 : 0;
    }
    EXPECT_GT(lighted, 1000);
}

}  // namespace
