// Surfels of the texels: position on the exact ray and plane, normals and albedo of the side that was seen, smooth normals by barycentric
// interpolation.
#include "kernels/kernel_test.h"
#include "reference/tolerances.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// Barycentric weights of a point in a triangle's plane.
dvec3 barycentric(const ref::Triangle& t, const dvec3& p) {
    const dvec3 n = glm::cross(t.v1 - t.v0, t.v2 - t.v0);
    const double area = glm::dot(n, n);
    return dvec3(glm::dot(n, glm::cross(t.v1 - p, t.v2 - p)), glm::dot(n, glm::cross(t.v2 - p, t.v0 - p)),
                 glm::dot(n, glm::cross(t.v0 - p, t.v1 - p))) /
           area;
}

void check(const TestScene& scene, const std::vector<float4>& centres, int n, bool smooth) {
    Kernels kernels = make_kernels(smooth);
    const DeviceScene on_device(device(), scene.flat);
    const GeometryMaps maps = rasterized(kernels, on_device, centres, n);
    const std::vector<Hit> hits = maps.hits.read();
    Surfels buffer(device(), maps.count * n * n, "surfels");
    gather_surfels(kernels, on_device, maps, 0, maps.count, buffer);
    ASSERT_EQ(buffer.count, maps.count * n * n);
    const HostSurfels surfels(buffer);
    int fronts = 0, backs = 0;
    for (int i = 0; i < surfels.count; ++i) {
        const int tile = i / (n * n), x = surfel_texel(i % (n * n), n).x, y = surfel_texel(i % (n * n), n).y;
        const Hit hit = hits[atlas_index(tile, x, y, n)];
        SCOPED_TRACE("tile " + std::to_string(tile) + " texel " + std::to_string(x) + " " + std::to_string(y) + " triangle " +
                     std::to_string(hit.triangle));
        if (hit.triangle < 0) {
            ASSERT_EQ(surfels.plane(i), -1);
            ASSERT_EQ(surfels.material(i), PENCIL_NO_MATERIAL);
            ASSERT_EQ(surfels.normal(i), dvec3(0.0));
            ASSERT_EQ(surfels.albedo(i), dvec3(0.0));
            continue;
        }
        const auto k = static_cast<std::size_t>(hit.triangle);
        const ref::Triangle& t = scene.triangles[k];
        const dvec3 centre = xyz(centres[static_cast<std::size_t>(tile)]), direction = ref::texel_direction(x, y, n);
        const ref::Crossing c = ref::cross_triangle(centre, direction, t);
        const dvec3 position = centre + c.t * direction;
        ASSERT_LE(glm::distance(surfels.position(i), position), tolerance::depth_tie * c.slant * c.t) << "position";
        ASSERT_EQ(surfels.plane(i), t.plane);
        const dvec3 face = glm::normalize(glm::cross(t.v1 - t.v0, t.v2 - t.v0));
        const bool front = glm::dot(face, direction) < 0.0;
        (front ? fronts : backs) += 1;
        const double side = front ? 1.0 : -1.0;
        ASSERT_LE(glm::distance(surfels.face_normal(i), side * face), tolerance::few_operations) << "geometric normal";
        const Material& m = scene.flat.materials[static_cast<std::size_t>(scene.flat.triangles[k].material)];
        const int material = scene.flat.triangles[k].material;
        ASSERT_EQ(surfels.material(i), front ? material : ~material);
        ASSERT_EQ(surfels.albedo(i), front || m.albedo.w > 0.5F ? xyz(m.albedo) : dvec3(0.0));
        dvec3 normal = side * face;
        if (smooth) {
            const dvec3 b = barycentric(t, position);
            const dvec3 sum =
                b.x * xyz(scene.flat.normals[3 * k]) + b.y * xyz(scene.flat.normals[3 * k + 1]) + b.z * xyz(scene.flat.normals[3 * k + 2]);
            if (glm::length(sum) > 0.0) normal = side * glm::normalize(sum);
            // Barycentric weights of slivers magnify the position's error.
            const double size = std::min({glm::distance(t.v0, t.v1), glm::distance(t.v1, t.v2), glm::distance(t.v2, t.v0)});
            ASSERT_LE(glm::distance(surfels.normal(i), normal), tolerance::depth_tie * c.slant * 20.0 / size) << "shading normal";
        } else {
            ASSERT_LE(glm::distance(surfels.normal(i), normal), tolerance::few_operations) << "shading normal";
        }
    }
    EXPECT_GT(fronts, 0);
    EXPECT_GT(backs, 0);
}

TEST(GatherSurfels, FlatScenes) {
    Random random(41);
    for (const int n : {8, 16, 24}) check(soup_scene(42, 60), random_centres(random, n == 8 ? 1 : 5), n, false);
}

TEST(GatherSurfels, SmoothNormals) {
    Random random(43);
    TestScene scene = soup_scene(44, 40);
    for (const ref::Triangle& t : scene.triangles) {
        const dvec3 face = glm::normalize(glm::cross(t.v1 - t.v0, t.v2 - t.v0));
        // Every fourth triangle has none: zero normals mean the face's.
        const bool flat = scene.flat.normals.size() % 4 == 0;
        for (int k = 0; k < 3; ++k)
            scene.flat.normals.push_back(flat ? float4(0.0F) : to_float4(glm::normalize(face + 0.6 * random.direction())));
    }
    check(scene, random_centres(random, 4), 16, true);
}

TEST(GatherSurfels, RangeOfTiles) {
    Random random(45);
    const TestScene scene = room_scene(46, 10);
    const std::vector<float4> centres = random_centres(random, 5);
    Kernels kernels = make_kernels();
    const DeviceScene on_device(device(), scene.flat);
    const int n = 8;
    const GeometryMaps maps = rasterized(kernels, on_device, centres, n);
    Surfels all(device(), 5 * n * n, "all"), part(device(), 2 * n * n, "part");
    gather_surfels(kernels, on_device, maps, 0, 5, all);
    gather_surfels(kernels, on_device, maps, 2, 2, part);
    const HostSurfels a(all), p(part);
    ASSERT_EQ(p.count, 2 * n * n);
    for (int i = 0; i < p.count; ++i) ASSERT_EQ(p.position(i), a.position(i + 2 * n * n)) << "surfel " << i;
}

}  // namespace
