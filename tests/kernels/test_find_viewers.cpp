// Which pencils some surfels see, against a count of segments that meet no triangle.
#include "kernels/surface_test.h"
#include "line/find_viewers.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// Surfels that see a centre in front of them, by brute force; unsure: those that depend on rounding.
struct Counted {
    int seen = 0, unsure = 0;
};

Counted count_viewers(const TestScene& scene, const MadeSurfels& surfels, const dvec3& centre) {
    Counted counted;
    for (int i = 0; i < surfels.count; ++i) {
        const dvec3 x = surfels.position(i), step = centre - x, direction = glm::normalize(step);
        const double cosine = glm::dot(direction, surfels.normal(i));
        if (std::abs(cosine) < 1e-4) ++counted.unsure;
        if (cosine <= 0 || surfels.bits(SURFEL_PLANE, i) < 0) continue;
        double free = ref::nearest_triangle(scene.triangles, x, direction).t;
        if (free < 1e-3) ++counted.unsure;  // what the surfel lies on, or touches
        if (std::abs(free - glm::length(step)) < 1e-3) ++counted.unsure;
        counted.seen += free > glm::length(step) ? 1 : 0;
    }
    return counted;
}

TEST(FindViewers, CountsSegmentsThatMeetNothing) {
    Kernels kernels = make_kernels();
    for (const int things : {0, 40})
        for (const int surfel_count : {1, 37, 200}) {
            const TestScene scene = room_scene(static_cast<std::uint32_t>(things) + 3, things);
            const DeviceScene on_device(device(), scene.flat, build_bvh(scene.flat.triangles));
            Random random(static_cast<std::uint32_t>(surfel_count));
            MadeSurfels surfels(surfel_count);
            for (int i = 0; i < surfel_count; ++i)  // in free space, of a plane that no triangle has
                surfels.place(i, random.in_box(-0.6, 0.6), random.direction(), 1 << 20, dvec3(0.5));
            std::vector<float4> centres;
            for (int i = 0; i < 21; ++i) centres.push_back(to_float4(random.in_box(-0.7, 0.7)));
            const std::vector<int> seen =
                find_viewers(kernels, on_device, surfels.on_device(), Buffer<float4>(device(), centres, "centres"));
            ASSERT_EQ(seen.size(), centres.size());
            for (std::size_t k = 0; k < centres.size(); ++k) {
                const Counted counted = count_viewers(scene, surfels, xyz(centres[k]));
                EXPECT_NEAR(seen[k], counted.seen, counted.unsure) << "centre " << k << " of " << things << " things";
            }
        }
}

TEST(FindViewers, SurfelsThatShowNothingSeeNothing) {
    Kernels kernels = make_kernels();
    const TestScene scene = box_scene(1);
    const DeviceScene on_device(device(), scene.flat, build_bvh(scene.flat.triangles));
    const std::vector<int> seen = find_viewers(kernels, on_device, MadeSurfels(5).on_device(),
                                               Buffer<float4>(device(), std::vector<float4>{float4(0.0F), float4(0.1F)}, "centres"));
    EXPECT_EQ(seen, (std::vector<int>{0, 0}));
}

}  // namespace
