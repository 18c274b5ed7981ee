// Scenes of several files: includes, search paths, meshes of Mitsuba's own, groups and their instances, and where files may lie.
#include <zlib.h>

#include <cstring>

#include "scene/meshes/read_serialized.h"
#include "unit/scene_fixture.h"

namespace pencil::test {
namespace {

const char* const triangle_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

class MitsubaFiles : public SceneTest {
protected:
    static std::string obj(const std::string& name) {
        return "<shape type=\"obj\"><string name=\"filename\" value=\"" + name + "\"/></shape>\n";
    }
};

template <class T>
void put(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A triangle at height z, as one mesh of a file.
std::string packed_mesh(float z, bool with_name, std::uint64_t vertices = 3, std::uint32_t last_index = 2) {
    std::string mesh;
    put(mesh, std::uint32_t{0x1000});
    if (with_name) mesh += std::string("name\0", 5);
    put(mesh, vertices);
    put(mesh, std::uint64_t{1});
    for (const float value : {0.0F, 0.0F, z, 1.0F, 0.0F, z, 0.0F, 1.0F, z}) put(mesh, value);
    for (const std::uint32_t index : {0U, 1U, last_index}) put(mesh, index);
    uLongf size = compressBound(mesh.size());
    std::string packed(size, '\0');
    compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(mesh.data()), mesh.size());
    std::string bytes;
    put(bytes, std::uint16_t{0x041C});
    put(bytes, std::uint16_t(with_name ? 4 : 3));
    return bytes + packed.substr(0, size);
}

std::string serialized(const std::string& first, const std::string& second) {
    std::string bytes = first + second;
    put(bytes, std::uint64_t{0});
    put(bytes, std::uint64_t(first.size()));
    put(bytes, std::uint32_t{2});
    return bytes;
}

TEST_F(MitsubaFiles, IncludesAndSearchPaths) {
    write("parts/room.xml",
          "<scene version=\"0.5.0\"><bsdf type=\"conductor\" id=\"m\"/><shape type=\"cube\"><ref id=\"m\"/></shape></scene>");
    write("parts/one.xml", "<bsdf type=\"plastic\" id=\"p\"/>");
    write("meshes/a.obj", triangle_obj);
    const Scene scene = load_body("<include filename=\"parts/room.xml\"/>\n<path value=\"meshes\"/>\n" + obj("a.obj") +
                                  "<include filename=\"parts\\one.xml\"/><shape type=\"cube\"><ref id=\"p\"/></shape>");
    EXPECT_EQ(scene.shapes.size(), 3U);
    EXPECT_FALSE(scene.materials[0].perfect_mirror);  // the included file is of the old version
    EXPECT_EQ(scene.materials.back().model, MATERIAL_PLASTIC);
    write("parts/bad.xml", "<scene version=\"3.0.0\">\n<shape type=\"obj\"/></scene>");
    EXPECT_NE(error_of_body("<include filename=\"parts/bad.xml\"/>").find("bad.xml:2: "), std::string::npos);
    write("parts/loop.xml", "<scene version=\"3.0.0\"><include filename=\"loop.xml\"/></scene>");
    EXPECT_NE(error_of_body("<include filename=\"parts/loop.xml\"/>").find("includes itself"), std::string::npos);
    write("parts/ping.xml", "<scene version=\"3.0.0\"><include filename=\"pong.xml\"/></scene>");
    write("parts/pong.xml", "<scene version=\"3.0.0\"><include filename=\"ping.xml\"/></scene>");
    EXPECT_NE(error_of_body("<include filename=\"parts/ping.xml\"/>").find("includes itself"), std::string::npos);
}

TEST_F(MitsubaFiles, ManyIncludesEnd) {
    for (int i = 0; i < 20; ++i) {
        const std::string next = "<include filename=\"i" + std::to_string(i + 1) + ".xml\"/>";
        write("i" + std::to_string(i) + ".xml", "<scene version=\"3.0.0\">" + next + next + "</scene>");
    }
    write("i20.xml", "<scene version=\"3.0.0\"/>");
    EXPECT_NE(error_of_body("<include filename=\"i0.xml\"/>").find("too many files are included"), std::string::npos);
}

TEST_F(MitsubaFiles, OtherFoldersMustBeAllowed) {
    write("common/a.obj", triangle_obj);
    const auto scene = write("scenes/s.xml", in_scene(obj("../common/a.obj")));
    EXPECT_THROW(load_scene(scene), SceneError);
    LoadOptions options;
    options.allowed = {folder_ / "common"};
    EXPECT_EQ(load_scene(scene, options).triangles.size(), 1U);
    const auto absolute = write("scenes/t.xml", in_scene(obj((folder_ / "common/a.obj").string())));
    EXPECT_EQ(load_scene(absolute, options).triangles.size(), 1U);
    options.allowed = {folder_ / "none"};
    EXPECT_THROW(load_scene(scene, options), SceneError);
    const auto own = write("scenes/u.xml", in_scene(obj((folder_ / "scenes/a.obj").string())));
    write("scenes/a.obj", triangle_obj);
    EXPECT_EQ(load_scene(own).triangles.size(), 1U);
}

/// Scenes come from systems where case does not matter, and with paths of their authors' machines.
TEST_F(MitsubaFiles, FilesThatLieElsewhereThanNamedAreFound) {
    write("Meshes/Wall.OBJ", triangle_obj);
    for (const char* name : {"meshes/wall.obj", "C:\\Users\\me\\scene\\meshes\\wall.obj", "/home/me/no/such/Meshes/Wall.OBJ",
                             "../MESHES/wall.obj", "scene/Meshes/Wall.OBJ"}) {
        const Scene scene = load_body(obj(name));
        EXPECT_EQ(scene.triangles.size(), 1U) << name;
        EXPECT_TRUE(has_warning(scene, "is not there; ")) << name;
    }
    expect_approximation(obj("meshes/wall.obj"), 3, "is read in its place");
    EXPECT_TRUE(load_body(obj("Meshes/Wall.OBJ")).warnings.empty());
    EXPECT_NE(error_of_body(obj("wall.obj")).find("does not exist"), std::string::npos) << "no search of other folders";
}

/// Neither by a link nor by another case may a name lead outside.
TEST_F(MitsubaFiles, StandInsLieInsideToo) {
    const std::filesystem::path outside = write("out/secret.obj", triangle_obj);
    const std::filesystem::path scene = write("in/scene.xml", in_scene(obj("Secret.OBJ")));
    std::filesystem::create_symlink(outside, folder_ / "in" / "secret.obj");
    std::filesystem::create_directory_symlink(folder_ / "out", folder_ / "in" / "sub");
    EXPECT_THROW(load_scene(scene), SceneError);
    write("in/scene.xml", in_scene(obj("SUB/SECRET.obj")));
    EXPECT_THROW(load_scene(scene), SceneError);
    write("in/scene.xml", in_scene(obj("../out/secret.obj")));
    write("in/copy/secret.obj", triangle_obj);
    EXPECT_THROW(load_scene(scene), SceneError) << "what exists outside is meant, and may be allowed";
}

TEST_F(MitsubaFiles, SerializedMeshes) {
    write("m.serialized", serialized(packed_mesh(1, true), packed_mesh(2, true)));
    const Scene scene = load_body(
        "<shape type=\"serialized\"><string name=\"filename\" value=\"m.serialized\"/><integer name=\"shape_index\" value=\"1\"/></shape>");
    ASSERT_EQ(scene.triangles.size(), 1U);
    EXPECT_EQ(scene.positions[0].z, 2.0);
    std::string old = packed_mesh(3, false);
    put(old, std::uint32_t{0});
    put(old, std::uint32_t{1});
    EXPECT_EQ(read_serialized(old, 0, "m").positions[0].z, 3.0);
}

TEST_F(MitsubaFiles, BadSerializedMeshesAreErrors) {
    const std::string good = serialized(packed_mesh(1, true), packed_mesh(2, true));
    EXPECT_THROW(read_serialized(good, 2, "m"), SceneError);
    EXPECT_THROW(read_serialized(serialized(packed_mesh(1, true, 1ULL << 40), ""), 0, "m"), SceneError);
    EXPECT_THROW(read_serialized(serialized(packed_mesh(1, true, 100000), ""), 0, "m"), SceneError);
    EXPECT_THROW(read_serialized(serialized(packed_mesh(1, true, 3, 3), ""), 0, "m"), SceneError);
    EXPECT_THROW(read_serialized(serialized(packed_mesh(NAN, true), ""), 0, "m"), SceneError);
    for (std::size_t n = 0; n < good.size(); ++n) {
        std::string damaged = good;
        damaged[n] = static_cast<char>(damaged[n] ^ 0x55);
        for (const std::string& bytes : {damaged, good.substr(0, n)}) {
            try {
                read_serialized(bytes, 1, "m");
            } catch (const SceneError&) {
            }
        }
    }
}

TEST_F(MitsubaFiles, InstancesAreCopies) {
    const Scene scene = load_body(
        "<shape type=\"shapegroup\" id=\"g\"><shape type=\"cube\"/><shape type=\"rectangle\"><bsdf type=\"plastic\"/></shape></shape>\n"
        "<shape type=\"instance\"><ref id=\"g\"/></shape>\n"
        "<shape type=\"instance\"><ref id=\"g\"/><transform name=\"to_world\"><translate x=\"10\"/></transform></shape>");
    EXPECT_EQ(scene.triangles.size(), 28U);
    EXPECT_EQ(scene.shapes.size(), 4U);
    EXPECT_EQ(scene.materials.size(), 2U);
    double largest = 0;
    for (const glm::dvec3& p : scene.positions) largest = std::max(largest, p.x);
    EXPECT_EQ(largest, 11.0);
    expect_error("<shape type=\"instance\"/>", 3, "needs a reference to one shapegroup");
}

/// Spheres of instances count, too.
TEST_F(MitsubaFiles, ThousandsOfSpheresAreCoarser) {
    const auto instances = [](int count) {
        std::string body =
            "<shape type=\"shapegroup\" id=\"g\"><shape type=\"sphere\"/><shape type=\"sphere\"/><shape type=\"rectangle\"/></shape>";
        for (int i = 0; i < count; ++i) body += "<shape type=\"instance\"><ref id=\"g\"/></shape>";
        return body;
    };
    EXPECT_EQ(load_body(instances(2)).triangles.size(), 2U * (2 * 1280 + 2));
    const Scene scene = load_body(instances(2000));
    EXPECT_EQ(scene.triangles.size(), 2000U * (2 * 320 + 2));
    EXPECT_TRUE(has_warning(scene, "there are 4000 spheres: each is made of 320 triangles, where few have 1280"));
}

TEST_F(MitsubaFiles, DisksAndCylinders) {
    constexpr double pi = 3.14159265358979323846;
    const auto area = [](const Scene& scene) {
        double sum = 0;
        for (std::size_t i = 0; i < scene.triangles.size(); ++i) sum += glm::length(face_vector(scene, i)) / 2;
        return sum;
    };
    const Scene disk = load_body("<shape type=\"disk\"/>");
    EXPECT_NEAR(area(disk), pi, 0.002);
    EXPECT_GT(face_vector(disk, 0).z, 0);
    const Scene cylinder = load_body(
        "<shape type=\"cylinder\"><point name=\"p0\" x=\"1\"/><point name=\"p1\" x=\"3\"/><float name=\"radius\" value=\"0.5\"/></shape>");
    EXPECT_NEAR(area(cylinder), 2 * pi, 0.002);
    for (std::size_t i = 0; i < cylinder.triangles.size(); ++i) {
        const glm::dvec3 corner = cylinder.positions[cylinder.triangles[i].corners.x];
        EXPECT_GT(glm::dot(face_vector(cylinder, i), corner * glm::dvec3(0, 1, 1)), 0);  // outward
        EXPECT_NEAR(glm::length(corner * glm::dvec3(0, 1, 1)), 0.5, 1e-12);
    }
    expect_error("<shape type=\"cylinder\"><point name=\"p1\" x=\"0\"/></shape>", 3, "the same point");
}

}  // namespace
}  // namespace pencil::test
