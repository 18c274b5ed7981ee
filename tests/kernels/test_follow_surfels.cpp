// Chains of lobes end where geometry says, and carry what the surfaces on their way leave of light.
#include "kernels/lobe_test.h"

namespace {

using namespace pencil;
using namespace pencil::test;

TEST(FollowSurfels, AMirrorShowsTheRoom) {
    Scene scene;
    add_box(scene, dvec3(0.0), dvec3(1.0), Surface{glm::vec3(0.5F, 0.25F, 0.75F)});
    SceneMaterial& mirror = scene.materials[1];  // at x = 1
    mirror.model = MATERIAL_CONDUCTOR;
    mirror.perfect_mirror = true;
    mirror.specular = glm::vec3(0.9F, 0.5F, 0.2F);
    look_at(scene, {0.3, 0.4, 0.5}, {1.0, 0.6, 0.45}, {0, 1, 0}, 60.0, 24, 24);
    LobeScene room(scene);
    const std::vector<int> starts = room.on(MATERIAL_CONDUCTOR);
    ASSERT_GT(starts.size(), 300U);
    const HostSurfels ends = room.follow(starts);
    for (std::size_t k = 0; k < starts.size(); ++k) {
        const int i = static_cast<int>(k);
        const dvec3 p = room.world(room.seen, starts[k]);
        dvec3 d = glm::normalize(p - room.eye());
        d.x = -d.x;
        double t = 1e9;
        for (int axis = 0; axis < 3; ++axis)
            if (std::abs(d[axis]) > 1e-9) t = std::min(t, ((d[axis] > 0.0 ? (axis == 0 ? 2.0 : 1.0) : 0.0) - p[axis]) / d[axis]);
        ASSERT_GE(ends.plane(i), 0);
        ASSERT_LT(glm::distance(room.world(ends, i), p + t * d), 2e-5) << "chain " << k;
        expect_close(ends.vector(SURFEL_TR, i), {0.9, 0.5, 0.2}, 1e-5, "throughput");
        expect_close(ends.albedo(i), {0.45, 0.125, 0.15}, 1e-5, "albedo");
        ASSERT_EQ(ends.at(SURFEL_SHARE, i), 1.0F) << "no light sample reaches a lobe without width";
    }
}

TEST(FollowSurfels, ASlabShiftsWhatIsBehindIt) {
    const double thickness = 0.3, index = 1.5;
    Scene scene;
    const Surface white{glm::vec3(0.8F)};
    add_quad(scene, "floor", {-9, -9, 0}, {18, 0, 0}, {0, 18, 0}, white);
    add_quad(scene, "top", {-9, -9, 1 + thickness}, {18, 0, 0}, {0, 18, 0}, white);
    add_quad(scene, "bottom", {-9, -9, 1}, {0, 18, 0}, {18, 0, 0}, white);
    for (const std::size_t m : {1, 2}) {
        scene.materials[m].model = MATERIAL_DIELECTRIC;
        scene.materials[m].eta = glm::vec3(index);
    }
    look_at(scene, {0, 0, 3}, {1.5, 0.7, 1}, {0, 0, 1}, 30.0, 16, 16);
    LobeScene made(scene);
    const std::vector<int> of_glass = made.on(MATERIAL_DIELECTRIC);
    ASSERT_GT(of_glass.size(), 200U);
    std::vector<int> starts;
    for (const int i : of_glass) starts.insert(starts.end(), 64, i);
    const HostSurfels ends = made.follow(starts);
    double carried = 0.0, square = 0.0;
    int through = 0, twice = 0;
    for (std::size_t k = 0; k < starts.size(); ++k) {
        const int i = static_cast<int>(k);
        const double factor = ends.at(SURFEL_TR, i);
        carried += factor;
        square += factor * factor;
        if (ends.plane(i) < 0) continue;
        const dvec3 p = made.world(made.seen, starts[k]), d = glm::normalize(p - made.eye()), end = made.world(ends, i);
        const dvec2 along = glm::normalize(dvec2(d));
        const double sine = glm::length(dvec2(d)), inside = sine / index, step = thickness * inside / std::sqrt(1.0 - inside * inside);
        const double shift = glm::dot(dvec2(end - p), along) - sine / std::sqrt(1.0 - sine * sine), steps = shift / step;
        ASSERT_NEAR(end.z, 0.0, 1e-5);
        ASSERT_NEAR(glm::dot(dvec2(end - p), dvec2(-along.y, along.x)), 0.0, 1e-4) << "in the plane of incidence";
        const double odd = std::round((steps - 1.0) / 2.0);
        ASSERT_NEAR(steps, 1.0 + 2.0 * odd, 2e-3) << "down, and up and down some times";
        (odd == 0.0 ? through : twice) += 1;
    }
    EXPECT_GT(through, 50 * twice);
    EXPECT_GT(twice, 0);
    const double count = static_cast<double>(starts.size()), mean = carried / count,
                 error = std::sqrt(std::max(square / count - mean * mean, 0.0) / count);
    EXPECT_NEAR(mean, 1.0, 4.0 * error + 1e-4) << "glass takes no light, and what is denser gives back what it takes";
}

TEST(FollowSurfels, WhatHasNoLobesStays) {
    Scene scene;
    add_box(scene, dvec3(0.0), dvec3(1.0), Surface{glm::vec3(0.5F)});
    scene.materials[1].model = MATERIAL_PHONG;
    scene.materials[1].specular = glm::vec3(0.4F);
    look_at(scene, {0.3, 0.4, 0.5}, {1.0, 0.6, 0.45}, {0, 1, 0}, 90.0, 16, 16);
    LobeScene room(scene);
    Surfels surfels(room.kernels, room.seen.count, "copy");
    surfels.data.write(room.film.surfels().data.read());
    follow_surfels(room.kernels, room.on_device, {room.no_lights, room.no_lights}, 0, 3, surfels);
    const HostSurfels after(surfels);
    int stayed = 0, moved = 0;
    for (int i = 0; i < after.count; ++i) {
        const bool same = after.position(i) == room.seen.position(i);
        if (room.flat.materials[static_cast<std::size_t>(room.seen.material(i))].model == MATERIAL_DIFFUSE) {
            ASSERT_TRUE(same);
            ASSERT_EQ(after.albedo(i), room.seen.albedo(i));
        } else {
            (same ? stayed : moved) += 1;
        }
    }
    EXPECT_GT(stayed, 0) << "for its base";
    EXPECT_GT(moved, 0) << "along its lobe";
}

}  // namespace
