// Which shape encloses a centre: backs over more than half of the sphere, by exact solid angles. Closed and open-bottomed boxes are found,
// walls seen from behind and rooms seen from inside are not.
#include <map>

#include "kernels/kernel_test.h"
#include "line/find_enclosing.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// A room with a solid box (shape 1, fronts outwards) in [-0.3, 0.3] x [-0.75, 0.1] x [-0.2, 0.4], without a bottom, and two walls (shapes
/// 2 and 3) back to back with a gap between them, where both backs together fill nearly everything but neither has more than half.
TestScene room_with_solid() {
    std::vector<ref::Triangle> triangles = box_triangles();
    for (ref::Triangle t : box_triangles(1.0)) {
        if (t.plane == 2) continue;  // the bottom
        for (dvec3* v : {&t.v0, &t.v1, &t.v2}) *v = ref::as_float(dvec3(0.0, -0.325, 0.1) + *v * dvec3(0.3, 0.425, 0.3));
        std::swap(t.v1, t.v2);
        t.plane += t.plane < 2 ? 6 : 5;
        triangles.push_back(t);
    }
    triangles.push_back({{0.5, -0.75, -0.75}, {0.5, 0.75, -0.75}, {0.5, 0, 0.75}, 11});
    triangles.push_back({{0.35, -0.75, -0.75}, {0.35, 0, 0.75}, {0.35, 0.75, -0.75}, 12});
    TestScene scene = make_scene(triangles, 4, 151);
    for (std::size_t i = 0; i < scene.flat.triangles.size(); ++i) scene.flat.triangles[i].shape = i < 12 ? 0 : i < 22 ? 1 : i == 22 ? 2 : 3;
    return scene;
}

TEST(FindEnclosing, AgainstSolidAnglesAndKnownPlaces) {
    const TestScene scene = room_with_solid();
    Random random(152);
    std::vector<float4> centres = random_centres(random, 60);
    centres.push_back(to_float4({0, -0.3, 0.1}));   // in the solid
    centres.push_back(to_float4({0.6, 0.2, 0.0}));  // behind the wall or in front of it, never inside
    for (int i = 0; i < 40; ++i)
        centres.push_back(to_float4({random.uniform(0.36, 0.49), random.uniform(-0.5, 0.2), random.uniform(-0.6, 0.0)}));
    for (const int n : {8, 16, 64}) {
        Kernels kernels = make_kernels();
        const DeviceScene on_device(device(), scene.flat);
        const GeometryMaps maps = rasterized(kernels, on_device, centres, n);
        const std::vector<Hit> hits = maps.hits.read();
        const std::vector<int> enclosing = find_enclosing(kernels, on_device, maps);
        for (int tile = 0; tile < maps.count; ++tile) {
            const dvec3 c = xyz(centres[static_cast<std::size_t>(tile)]);
            std::map<int, double> back;
            for (int i = 0; i < n * n; ++i) {
                const Hit hit = hits[atlas_index(tile, i % n, i / n, n)];
                if (hit.triangle < 0) continue;
                const ref::Triangle& t = scene.triangles[static_cast<std::size_t>(hit.triangle)];
                if (glm::dot(glm::cross(t.v1 - t.v0, t.v2 - t.v0), c - t.v0) < 0.0)
                    back[scene.flat.triangles[static_cast<std::size_t>(hit.triangle)].shape] += ref::texel_solid_angle(i % n, i / n, n);
            }
            int expected = -1;
            double share = 0.0;
            for (const auto& [shape, angle] : back) {
                if (angle > share) {
                    share = angle;
                    expected = angle > 2.0 * ref::pi ? shape : -1;
                }
            }
            if (std::abs(share / (2.0 * ref::pi) - 1.0) < 0.02) continue;  // the kernel's solid angles are those of texel centres
            ASSERT_EQ(enclosing[static_cast<std::size_t>(tile)], expected)
                << "n " << n << " tile " << tile << " share " << share / (4.0 * ref::pi);
            const bool inside = std::abs(c.x) < 0.3 && c.y < 0.1 && std::abs(c.z - 0.1) < 0.3;
            ASSERT_TRUE(n < 64 || (enclosing[static_cast<std::size_t>(tile)] == 1) == inside)
                << "centre " << c.x << " " << c.y << " " << c.z;
        }
    }
}

}  // namespace
