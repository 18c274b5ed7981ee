// The scenes in scenes/ are what scenes/README.md says: all of them load without a warning and have the triangles that are expected.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <iterator>
#include <map>
#include <stdexcept>

#include "unit/scene_fixture.h"

namespace pencil::test {
namespace {

const std::filesystem::path scenes_folder = std::filesystem::path(PENCIL_SOURCE_DIR) / "scenes";

const Shape& shape_of(const Scene& scene, const std::string& id) {
    const auto place = std::find_if(scene.shapes.begin(), scene.shapes.end(), [&](const Shape& shape) { return shape.id == id; });
    if (place == scene.shapes.end()) throw std::runtime_error("no shape " + id);
    return *place;
}

TEST(ProjectScenes, LoadWithoutWarningsAndHaveTheirTriangles) {
    const std::map<std::string, std::size_t> expected = {
        {"colonnade", 100365},   {"cornell-box", 38},     {"door-ajar", 15710},  {"furnace", 12},
        {"glossy-plates", 5132}, {"lamp-hall", 4062},     {"lit-wall", 12},      {"office", 1128},
        {"still-life", 14520},   {"textured-room", 1814}, {"thin-walls", 15752}, {"two-rooms", 24},
    };
    std::size_t found = 0;
    for (const auto& entry : std::filesystem::directory_iterator(scenes_folder)) {
        if (entry.path().extension() != ".xml") continue;
        ++found;
        const std::string name = entry.path().stem();
        SCOPED_TRACE(name);
        const Scene scene = load_scene(entry.path());
        EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
        ASSERT_EQ(expected.count(name), 1U) << "a new scene: add it here and to scenes/README.md";
        EXPECT_EQ(scene.triangles.size(), expected.at(name));
    }
    EXPECT_EQ(found, expected.size());
}

TEST(ProjectScenes, InteriorIsTheSameAsTextAndAsBinary) {
    const Scene text = load_scene(scenes_folder / "interior.gltf"), binary = load_scene(scenes_folder / "interior.glb");
    EXPECT_TRUE(text.warnings.empty()) << text.warnings[0];
    EXPECT_EQ(text.triangles.size(), 1864U);
    EXPECT_EQ(text.positions, binary.positions);
    EXPECT_EQ(text.normals, binary.normals);
    EXPECT_EQ(text.uvs, binary.uvs);
    ASSERT_EQ(text.textures.size(), 2U);
    EXPECT_EQ(text.textures[1].texels, binary.textures[1].texels);
    EXPECT_EQ(text.point_lights.size(), 2U);
    EXPECT_EQ(shape_of(text, "lamp shade").radiance, shape_of(binary, "lamp shade").radiance);
    EXPECT_EQ(text.sensor.to_world, binary.sensor.to_world);
}

TEST(ProjectScenes, DoorAjarHasItsLightTurnedAwayFromTheRoom) {
    const Scene scene = load_scene(scenes_folder / "door-ajar.xml");
    const Shape& panel = shape_of(scene, "light panel");
    for (std::size_t t = panel.first_triangle; t < panel.first_triangle + panel.triangle_count; ++t) {
        expect_near(glm::normalize(face_vector(scene, t)), {0, 0, -1}, 1e-12);
        // Behind its plane is all of the camera's room, which begins at z = 0.
        EXPECT_LT(scene.positions[scene.triangles[t].corners.x].z, -0.12);
    }
    EXPECT_GT(scene.sensor.to_world[3].z, 0.0);
}

TEST(ProjectScenes, ThinWallsAreCutOpenAtTheFrontWall) {
    const Scene scene = load_scene(scenes_folder / "thin-walls.xml");
    const double plane = scene.sensor.to_world[3].z - scene.sensor.near_clip;
    EXPECT_LT(plane, 0.0);  // the front wall is z = 0
    EXPECT_GT(plane, -0.05);
    // The image is the house, edge to edge: its corners (+-3.2, 0 and 6.4) in that plane, seen through the offset film.
    const double half = scene.sensor.near_clip * std::tan(scene.sensor.fov_x * M_PI / 360);
    EXPECT_NEAR(half, 3.2, 1e-6);
    EXPECT_NEAR(scene.sensor.to_world[3].x - 2 * half * scene.sensor.principal_point_offset.x, 0.0, 1e-6);
    EXPECT_NEAR(scene.sensor.to_world[3].y + 2 * half * scene.sensor.principal_point_offset.y, 3.2, 1e-6);
}

std::string content_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

using ProjectMeshes = SceneTest;

TEST_F(ProjectMeshes, AreThoseOfTheirScript) {
    const std::string command = "python3 -B \"" PENCIL_SOURCE_DIR "/scripts/make_meshes.py\" \"" + folder_.string() + "\" > /dev/null";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    std::size_t made = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
        ++made;
        const std::filesystem::path kept = scenes_folder / "meshes" / entry.path().filename();
        EXPECT_TRUE(content_of(entry.path()) == content_of(kept)) << kept << " differs: run scripts/make_meshes.py";
    }
    EXPECT_EQ(made, 26U);
}

}  // namespace
}  // namespace pencil::test
