// Probing rays meet what brute force in double precision meets, and say where, on which side and with which albedo.
#include "kernel_test.h"
#include "line/placement/trace_probing_rays.h"
#include "reference/tolerances.h"

namespace {

using namespace pencil;
using namespace pencil::test;

std::vector<ProbingRay> random_rays(std::uint32_t seed, int count) {
    Random random(seed);
    std::vector<ProbingRay> rays;
    for (int i = 0; i < count; ++i) {
        const dvec3 origin = ref::as_float(random.in_box(-0.7, 0.7)), direction = ref::as_float(random.direction());
        rays.push_back({origin, direction, 0.0});
    }
    return rays;
}

/// Index of the triangle that brute force meets, checked against the kernel's hit; -1 for what float arithmetic may decide otherwise.
int expect_nearest(const TestScene& scene, const ProbingRay& ray, const ProbingHit& hit) {
    const ref::RayHit expected = ref::nearest_triangle(scene.triangles, ray.origin, ray.direction);
    if (expected.margin < pencil::tolerance::edge_tie) return -1;
    EXPECT_NEAR(hit.distance, expected.t, 1e-4 * expected.slant * 1e-2 + 1e-5);
    EXPECT_LT(glm::distance(hit.position, ray.origin + hit.distance * ray.direction), 1e-5);
    return expected.triangle;
}

TEST(TraceProbingRays, MeetsWhatBruteForceMeets) {
    Kernels kernels = make_kernels();
    for (const auto& [things, count] : {std::pair{0, 1}, std::pair{1, 37}, std::pair{40, 300}, std::pair{3000, 200}}) {
        SCOPED_TRACE(std::to_string(things) + " things, " + std::to_string(count) + " rays");
        const TestScene scene = room_scene(static_cast<std::uint32_t>(things) + 3, things);
        const DeviceScene on_device(device(), scene.flat, build_bvh(scene.flat.triangles));
        const std::vector<ProbingRay> rays = random_rays(9, count);
        const std::vector<ProbingHit> hits = trace_probing_rays(kernels, on_device, rays);
        ASSERT_EQ(hits.size(), rays.size());
        int ties = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const int met = expect_nearest(scene, rays[i], hits[i]);
            if (met < 0) {
                ++ties;
                continue;
            }
            const Material& m =
                scene.flat.materials[static_cast<std::size_t>(scene.flat.triangles[static_cast<std::size_t>(met)].material)];
            const dvec3 normal = xyz(scene.flat.planes[static_cast<std::size_t>(scene.triangles[static_cast<std::size_t>(met)].plane)]);
            const bool front = glm::dot(normal, rays[i].direction) < 0.0;
            EXPECT_LT(glm::distance(hits[i].normal, front ? normal : -normal), 1e-6);
            const dvec3 albedo = front || m.albedo.w != 0.0F ? xyz(m.albedo) : dvec3(0.0);
            EXPECT_EQ(hits[i].albedo, albedo);
        }
        EXPECT_LE(ties, 1 + count / 100);
    }
}

TEST(TraceProbingRays, NothingIsInfinitelyFar) {
    Kernels kernels = make_kernels();
    const TestScene scene = soup_scene(4, 1);
    const DeviceScene on_device(device(), scene.flat, build_bvh(scene.flat.triangles));
    const ref::Triangle& t = scene.triangles.front();
    const dvec3 away = ref::as_float(glm::normalize(glm::cross(t.v1 - t.v0, t.v2 - t.v0))), origin = ref::as_float(t.v0 + 0.5 * away);
    const std::vector<ProbingHit> hits = trace_probing_rays(kernels, on_device, {{origin, away, 0.0}, {origin, -away, 0.0}});
    EXPECT_TRUE(std::isinf(hits[0].distance));
    EXPECT_EQ(hits[0].albedo, dvec3(0.0));
    EXPECT_TRUE(trace_probing_rays(kernels, on_device, {}).empty());
}

TEST(TraceProbingRays, LeavesTheSurfaceItStartsOnButNotItsNeighbour) {
    Kernels kernels = make_kernels();
    const TestScene scene = box_scene(3);
    const DeviceScene on_device(device(), scene.flat, build_bvh(scene.flat.triangles));
    // From the wall x = -0.75 into the room, from so near its neighbour y = -0.75 that only their planes tell them apart.
    ProbingRay ray{ref::as_float({-0.75, -0.75 + 1e-7, 0.1}), {1.0, 0.0, 0.0}, 0.0};
    ray.plane = 0;
    ProbingRay down = ray;
    down.direction = ref::as_float(glm::normalize(dvec3(0.1, -1.0, 0.0)));
    const std::vector<ProbingHit> hits = trace_probing_rays(kernels, on_device, {ray, down});
    EXPECT_NEAR(hits[0].distance, 1.5, 1e-5);
    EXPECT_EQ(hits[0].plane, 1);
    EXPECT_LT(hits[1].distance, 1e-5);
    EXPECT_EQ(hits[1].plane, 2);
}

}  // namespace
