// The fingerprint changes with everything that changes the picture and with nothing else.
#include <gtest/gtest.h>

#include "scene/scene_fingerprint.h"
#include "util/fingerprint.h"

namespace pencil {
namespace {

Scene one_triangle() {
    Scene scene;
    scene.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    scene.normals.assign(3, glm::vec3(0));
    scene.triangles = {{{0, 1, 2}, 0}};
    scene.materials.resize(1);
    scene.shapes.resize(1);
    scene.shapes[0].triangle_count = 1;
    return scene;
}

TEST(SceneFingerprint, ChangesWithThePicture) {
    const std::string before = scene_fingerprint(one_triangle());
    EXPECT_EQ(before.size(), 16U);
    const auto changed = [&](auto change) {
        Scene scene = one_triangle();
        change(scene);
        return scene_fingerprint(scene) != before;
    };
    EXPECT_TRUE(changed([](Scene& s) { s.positions[1].z = 1e-9; }));
    EXPECT_TRUE(changed([](Scene& s) { s.triangles[0].corners = {0, 2, 1}; }));
    EXPECT_TRUE(changed([](Scene& s) { s.materials[0].albedo.y = 0.51F; }));
    EXPECT_TRUE(changed([](Scene& s) { s.materials[0].two_sided = true; }));
    EXPECT_TRUE(changed([](Scene& s) { s.triangles[0].material = 1; }));
    EXPECT_TRUE(changed([](Scene& s) { s.shapes[0].radiance.x = 1; }));
    EXPECT_TRUE(changed([](Scene& s) { s.point_lights.push_back({{0, 0, 1}, {1, 1, 1}}); }));
    EXPECT_TRUE(changed([](Scene& s) { s.materials[0].model = MATERIAL_PHONG; }));
    EXPECT_TRUE(changed([](Scene& s) { s.materials[0].alpha.y = 0.1F; }));
    EXPECT_TRUE(changed([](Scene& s) { s.materials[0].principled.sheen = 0.1F; }));
    EXPECT_TRUE(changed([](Scene& s) { s.materials[0].normal_texture = 0; }));
    EXPECT_TRUE(changed([](Scene& s) { s.textures.resize(1); }));
    EXPECT_TRUE(changed([](Scene& s) { s.shapes[0].radiance_texture = 0; }));
    EXPECT_TRUE(changed([](Scene& s) { s.directional_lights.push_back({{0, 0, 1}, {1, 1, 1}}); }));
    EXPECT_TRUE(changed([](Scene& s) { s.environment.emplace(); }));
    EXPECT_TRUE(changed([](Scene& s) { s.profiles.resize(1); }));
    EXPECT_TRUE(changed([](Scene& s) { s.sensor.aperture_radius = 0.1; }));
    EXPECT_TRUE(changed([](Scene& s) { s.sensor.crop_width = 1; }));
    EXPECT_TRUE(changed([](Scene& s) { s.sensor.to_world[3].x = 1; }));
    EXPECT_TRUE(changed([](Scene& s) { s.sensor.filter.kind = ReconstructionFilter::Kind::box; }));
}

TEST(SceneFingerprint, IgnoresNamesAndWhatOptionsReplace) {
    Scene scene = one_triangle();
    scene.file = "other.xml";
    scene.shapes[0].id = "floor";
    scene.sensor.width = 3;
    scene.max_depth = 2;
    EXPECT_EQ(scene_fingerprint(scene), scene_fingerprint(one_triangle()));
}

TEST(SceneFingerprint, IgnoresHowTrianglesShareVertices) {
    Scene shared = one_triangle(), split = one_triangle();
    shared.triangles.push_back({{2, 1, 0}, 0});
    split.positions.insert(split.positions.end(), {{0, 1, 0}, {1, 0, 0}, {0, 0, 0}});
    split.normals.assign(6, glm::vec3(0));
    split.uvs.assign(6, glm::vec2(0.5F));
    split.triangles.push_back({{3, 4, 5}, 0});
    EXPECT_EQ(scene_fingerprint(shared), scene_fingerprint(split));
    EXPECT_NE(scene_fingerprint(shared), scene_fingerprint(one_triangle()));
}

TEST(SceneFingerprint, OfBytesIsFnv1a) {
    EXPECT_EQ(fingerprint("", 0), "cbf29ce484222325");  // published test vectors
    EXPECT_EQ(fingerprint("foobar", 6), "85944171f73967e8");
}

}  // namespace
}  // namespace pencil
