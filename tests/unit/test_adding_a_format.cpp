// The format of docs/adding_a_format.md: a room in two lines of text. Its code stands there as here.
#include <glm/geometric.hpp>

#include "scene/meshes/mesh.h"
#include "scene/scene_file.h"
#include "scene/text.h"
#include "unit/scene_fixture.h"

namespace pencil::test {
namespace {

// host/scene/room/read_room.cpp

bool is_room(std::string_view head) { return head.substr(0, 5) == "room\n"; }

/// "room", then the width, height and depth of a grey room around the camera.
Scene read_room(const std::filesystem::path& file, const LoadOptions&) {
    const std::string text = read_regular_file(file, max_xml_bytes, shown(file));
    const std::vector<std::string_view> words = tokens(text);
    if (words.size() != 4) throw SceneError(shown(file) + ":2", "three sizes are needed, as in \"4 3 5\"");
    MeshPlacement placement;
    placement.flip_normals = true;  // seen from inside
    for (int k = 0; k < 3; ++k) {
        const std::optional<double> size = parse_number(words[static_cast<std::size_t>(k) + 1]);
        if (!size || !(*size > 0)) throw SceneError(shown(file) + ":2", "a size is " + in_quotes(words[static_cast<std::size_t>(k) + 1]));
        placement.to_world[k][k] = *size / 2;
    }
    Scene scene;
    scene.file = file.string();
    scene.materials.push_back({"wall", MATERIAL_DIFFUSE, glm::vec3(0.5F)});
    place_mesh(make_cube(), placement, {0, 0}, shown(file), scene);
    scene.shapes.push_back({"room", "cube", 0, static_cast<std::uint32_t>(scene.triangles.size())});
    scene.point_lights.push_back({glm::dvec3(0.0), glm::vec3(1.0F)});
    return scene;
}

class AddingAFormat : public SceneTest {
protected:
    Scene load(const std::string& text) const {
        std::vector<SceneFormat> formats = scene_formats();  // the program's own table, and the new row
        formats.push_back({"room", is_room, read_room});
        return load_scene(write("scene.room", text), {}, formats);
    }
    std::string defect_of(const std::string& text) const {
        try {
            load(text);
        } catch (const SceneError& error) {
            return error.what();
        }
        return "";
    }
};

TEST_F(AddingAFormat, ARowAndAReaderAreAll) {
    const Scene scene = load("room\n4 3 5\n");
    EXPECT_EQ(scene.triangles.size(), 12U);
    EXPECT_EQ(scene.shapes.at(0).triangle_count, 12U);
    for (std::size_t t = 0; t < 12; ++t)
        EXPECT_LT(glm::dot(face_vector(scene, t), scene.positions[scene.triangles[t].corners.x]), 0.0) << "the fronts look inwards";
    EXPECT_EQ(load(in_scene("<shape type=\"cube\"/>")).shapes.size(), 1U) << "Mitsuba's scenes are read as before";
}

TEST_F(AddingAFormat, DefectsNameTheFileAndTheLine) {
    EXPECT_NE(defect_of("room\n4 3\n").find("scene.room:2: three sizes are needed"), std::string::npos);
    EXPECT_NE(defect_of("room\n4 3 \x1b[31m\n").find("scene.room:2: a size is \"\\x1b[31m\""), std::string::npos);
    EXPECT_NE(defect_of("house\n").find("Mitsuba XML, room"), std::string::npos);
}

}  // namespace
}  // namespace pencil::test
