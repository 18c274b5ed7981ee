// Texels of the maps of a field: each is seen through a point of its own, rays through the hierarchy meet what brute force meets, and points of
// successive turns fill texels evenly.
#include "kernels/surface_test.h"
#include "surface/trace_field.h"

namespace {

using namespace pencil;
using namespace pencil::test;

struct TracedField {
    std::vector<SurfacePencil> placed;
    HostSurfels surfels;
};

/// What pencils first .. first + count of a set of `all` see.
TracedField trace(Kernels& kernels, const TestScene& scene, int all, int first, int count, int n, const TexelPoints& points = {7}) {
    const DeviceScene on_device(device(), scene.flat, build_bvh(scene.flat.triangles));
    const std::vector<SurfacePencil> placed = random_pencils(5, all);
    SurfacePencils pencils(device(), all, n);
    pencils.data.write(placed);
    pencils.count = all;
    Surfels surfels(device(), count * n * n, "surfels");
    trace_field(kernels, on_device, pencils, first, count, points, surfels);
    EXPECT_EQ(surfels.count, count * n * n);
    return {placed, HostSurfels(surfels)};
}

TEST(TraceField, EveryTexelIsSeenThroughAPointOfItsOwn) {
    Kernels kernels = make_kernels();
    const TestScene scene = box_scene(1);
    for (const int count : {1, 5, 37})
        for (const int n : {4, 8, 24}) {
            const TracedField t = trace(kernels, scene, count, 0, count, n);
            for (int i = 0; i < count * n * n; ++i) {
                const dvec3 from = xyz(t.placed[static_cast<std::size_t>(i / (n * n))].position);
                const dvec2 uv = ref::direction_to_oct(t.surfels.position(i) - from);
                const glm::ivec2 texel = field_texel(i % (n * n), n);
                const dvec2 within = (uv + 1.0) * 0.5 * static_cast<double>(n) - dvec2(texel);
                for (int k = 0; k < 2; ++k) {
                    ASSERT_GT(within[k], -2e-4 * n) << "entry " << i << ", n " << n;
                    ASSERT_LT(within[k], 1 + 2e-4 * n) << "entry " << i << ", n " << n;
                }
            }
        }
}

TEST(TraceField, MeetsWhatBruteForceMeets) {
    Kernels kernels = make_kernels();
    for (const int things : {0, 1, 40}) {
        const TestScene scene = room_scene(static_cast<std::uint32_t>(things) + 3, things);
        const int count = 3, n = 8;
        const TracedField t = trace(kernels, scene, count, 0, count, n);
        int wrong = 0;
        for (int i = 0; i < count * n * n; ++i) {
            const dvec3 from = xyz(t.placed[static_cast<std::size_t>(i / (n * n))].position), point = t.surfels.position(i);
            ASSERT_GE(t.surfels.plane(i), 0) << "every ray meets something";
            const ref::RayHit hit = ref::nearest_triangle(scene.triangles, from, glm::normalize(point - from));
            wrong += std::abs(hit.t - glm::distance(from, point)) > 1e-4 ? 1 : 0;
        }
        EXPECT_LE(wrong, 1) << things << " things: at most one ray along an edge may differ";
    }
}

TEST(TraceField, APartOfAFieldIsTracedAsTheWholeIs) {
    Kernels kernels = make_kernels();
    const TestScene scene = room_scene(4, 20);
    const int n = 8, first = 3, count = 5;
    const TracedField all = trace(kernels, scene, 9, 0, 9, n), part = trace(kernels, scene, 9, first, count, n);
    for (int f = 0; f < SURFEL_FIELDS; ++f)
        for (int i = 0; i < count * n * n; ++i)
            ASSERT_EQ(part.surfels.bits(f, i), all.surfels.bits(f, first * n * n + i)) << "field " << f << " of surfel " << i;
}

TEST(TraceField, EveryTexelHasOneEntry) {
    for (const int n : {4, 8, 24}) {
        std::vector<int> seen(static_cast<std::size_t>(n * n), 0);
        for (int i = 0; i < n * n; ++i) {
            const glm::ivec2 texel = field_texel(i, n);
            ++seen[static_cast<std::size_t>(texel.y * n + texel.x)];
        }
        for (const int times : seen) EXPECT_EQ(times, 1) << n;
    }
}

TEST(TraceField, TurnsSeeOtherPoints) {
    Kernels kernels = make_kernels();
    const TestScene scene = box_scene(1);
    const TracedField a = trace(kernels, scene, 2, 0, 2, 8, {7, 0}), b = trace(kernels, scene, 2, 0, 2, 8, {7, 1});
    int same = 0;
    for (int i = 0; i < 2 * 64; ++i) same += a.surfels.position(i) == b.surfels.position(i) ? 1 : 0;
    EXPECT_EQ(same, 0);
}

}  // namespace
