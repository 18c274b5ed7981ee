// Analytic density weights against p = d^3 / (3 volume) with d from rays cast both ways through every triangle, in double precision.
#include "kernels/kernel_test.h"
#include "line/free_path_density.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// From `origin` along the unit `direction` to what is met or to the side of the box [-half, half]^3.
double free_distance(const TestScene& scene, const dvec3& origin, const dvec3& direction, double half) {
    double end = ref::nearest_triangle(scene.triangles, origin, direction).t;
    for (int axis = 0; axis < 3; ++axis) end = std::min(end, (std::copysign(half, direction[axis]) - origin[axis]) / direction[axis]);
    return end;
}

void check(const TestScene& scene, int pencils, int n, int first, int count, double half, std::uint32_t seed) {
    SCOPED_TRACE(std::to_string(pencils) + " pencils, n " + std::to_string(n));
    Random random(seed);
    const std::vector<float4> centres = random_centres(random, pencils, 0.9 * half);
    Kernels kernels = make_kernels();
    const DeviceScene on_device(device(), scene.flat);
    PencilSet set(device(), std::make_shared<GeometryMaps>(rasterized(kernels, on_device, centres, n)));
    const float4 untouched(1.0F, 2.0F, 3.0F, -9.0F);
    set.radiance.write(std::vector<float4>(set.radiance.size(), untouched));
    const double volume = 0.7 * 8.0 * half * half * half;
    free_path_density(kernels, first, count, {dvec3(-half), dvec3(half), volume}, set);
    const std::vector<float4> radiance = set.radiance.read();
    int wrong = 0, texels = 0;
    for (int tile = 0; tile < pencils; ++tile) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                const float4 texel = radiance[atlas_index(tile, x, y, n)];
                ASSERT_EQ(xyz(texel), xyz(untouched));
                if (tile < first || tile >= first + count) {
                    ASSERT_EQ(texel.w, untouched.w) << "tile " << tile << " is outside the range";
                    continue;
                }
                const dvec3 direction = glm::normalize(ref::texel_direction(x, y, n)),
                            centre = xyz(centres[static_cast<std::size_t>(tile)]);
                const double d = free_distance(scene, centre, direction, half) + free_distance(scene, centre, -direction, half);
                const double density = d * d * d / (3.0 * volume) + 0.02 / (2.0 * ref::pi);
                ++texels;
                if (!(std::abs(texel.w * density - 1.0) < 1e-4)) ++wrong;
            }
        }
    }
    EXPECT_LE(wrong, texels / 1000) << "of " << texels << "; only rays along an edge may be decided otherwise";
}

TEST(FreePathDensity, BoxRoomAndOpenSpace) {
    check(box_scene(81), 1, 8, 0, 1, 0.75, 82);
    check(box_scene(81), 5, 24, 1, 3, 0.75, 83);
    check(room_scene(84, 20), 7, 32, 0, 7, 0.75, 85);
    check(soup_scene(86, 3), 6, 16, 0, 6, 1.0, 87);
}

}  // namespace
