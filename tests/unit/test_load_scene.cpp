// Every feature of scene files against values worked out by hand.
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include "unit/scene_fixture.h"

namespace pencil::test {
namespace {

using LoadScene = SceneTest;

TEST_F(LoadScene, ModernAndOldNamesMeanTheSame) {
    const auto scene_of = [](bool old) {
        const auto name = [&](const char* modern, const char* camel) { return std::string(old ? camel : modern); };
        return "<scene version=\"" + name("3.0.0", "0.6.0") + "\"><integrator type=\"path\"><integer name=\"" +
               name("max_depth", "maxDepth") + "\" value=\"6\"/><integer name=\"" + name("rr_depth", "rrDepth") +
               "\" value=\"5\"/></integrator><sensor type=\"perspective\"><float name=\"" + name("near_clip", "nearClip") +
               "\" value=\"0.5\"/><float name=\"" + name("far_clip", "farClip") +
               "\" value=\"50\"/><float name=\"fov\" value=\"30\"/><string name=\"" + name("fov_axis", "fovAxis") +
               "\" value=\"y\"/><transform name=\"" + name("to_world", "toWorld") +
               "\"><lookat origin=\"0, 0, -3\" target=\"0, 0, 0\" up=\"0, 1, 0\"/></transform><film type=\"" + name("hdrfilm", "ldrfilm") +
               "\"><integer name=\"width\" value=\"200\"/><integer name=\"height\" value=\"100\"/>" + "<string name=\"" +
               name("pixel_format", "pixelFormat") + "\" value=\"rgb\"/><rfilter type=\"tent\"/></film>" +
               "<sampler type=\"independent\"><integer name=\"" + name("sample_count", "sampleCount") +
               "\" value=\"8\"/></sampler></sensor></scene>";
    };
    for (const bool old : {false, true}) {
        const Scene scene = load_text(scene_of(old));
        EXPECT_EQ(scene.max_depth, 6);
        EXPECT_DOUBLE_EQ(scene.sensor.near_clip, 0.5);
        EXPECT_DOUBLE_EQ(scene.sensor.far_clip, 50.0);
        EXPECT_EQ(scene.sensor.width, 200);
        EXPECT_EQ(scene.sensor.height, 100);
        EXPECT_NEAR(scene.sensor.fov_x, 2 * std::atan(2 * std::tan(15 * M_PI / 180)) * 180 / M_PI, 1e-12);
        EXPECT_EQ(scene.sensor.to_world[3], glm::dvec4(0, 0, -3, 1));
        EXPECT_EQ(scene.sensor.filter.kind, ReconstructionFilter::Kind::tent);
        EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
    }
}

TEST_F(LoadScene, FieldOfViewAxes) {
    const auto fov = [&](const std::string& parameters, int width, int height) {
        return load_text("<scene version=\"3.0.0\"><sensor type=\"perspective\">" + parameters +
                         "<film type=\"hdrfilm\"><integer name=\"width\" value=\"" + std::to_string(width) +
                         "\"/><integer name=\"height\" value=\"" + std::to_string(height) + "\"/></film></sensor></scene>")
            .sensor.fov_x;
    };
    const auto along = [](const std::string& axis) {
        return "<float name=\"fov\" value=\"90\"/><string name=\"fov_axis\" value=\"" + axis + "\"/>";
    };
    const double wide = 2 * std::atan(2.0) * 180 / M_PI, narrow = 2 * std::atan(0.5) * 180 / M_PI;
    EXPECT_NEAR(fov("<float name=\"fov\" value=\"90\"/>", 200, 100), 90, 1e-12);
    EXPECT_NEAR(fov(along("x"), 200, 100), 90, 1e-12);
    EXPECT_NEAR(fov(along("y"), 200, 100), wide, 1e-12);
    EXPECT_NEAR(fov(along("y"), 100, 200), narrow, 1e-12);
    EXPECT_NEAR(fov(along("smaller"), 200, 100), wide, 1e-12);
    EXPECT_NEAR(fov(along("smaller"), 100, 200), 90, 1e-12);
    EXPECT_NEAR(fov(along("larger"), 200, 100), 90, 1e-12);
    EXPECT_NEAR(fov(along("larger"), 100, 200), narrow, 1e-12);
    EXPECT_NEAR(fov(along("diagonal"), 300, 400), 2 * std::atan(0.6) * 180 / M_PI, 1e-12);
    // A diagonal of sqrt(36^2 + 24^2) mm on a 3:2 film is 36 mm wide.
    EXPECT_NEAR(fov("<string name=\"focal_length\" value=\"18mm\"/>", 300, 200), 90, 1e-12);
    EXPECT_NEAR(fov("<string name=\"focalLength\" value=\"18\"/>", 300, 200), 90, 1e-12);
    EXPECT_NEAR(fov("", 300, 200), 2 * std::atan(18.0 / 50) * 180 / M_PI, 1e-12);
}

TEST_F(LoadScene, ReconstructionFilters) {
    const auto filter = [&](const std::string& rfilter, const std::string& version = "3.0.0") {
        return load_text("<scene version=\"" + version + "\"><sensor type=\"perspective\"><film type=\"hdrfilm\">" + rfilter +
                         "</film></sensor></scene>")
            .sensor.filter;
    };
    using Kind = ReconstructionFilter::Kind;
    EXPECT_EQ(filter("").kind, Kind::gaussian);
    EXPECT_DOUBLE_EQ(filter("").radius, 2.0);
    EXPECT_EQ(filter("<rfilter type=\"box\"/>").kind, Kind::box);
    EXPECT_DOUBLE_EQ(filter("<rfilter type=\"box\"/>").radius, 0.5);
    EXPECT_DOUBLE_EQ(filter("<rfilter type=\"tent\"/>").radius, 1.0);
    EXPECT_DOUBLE_EQ(filter("<rfilter type=\"tent\"><float name=\"radius\" value=\"1.5\"/></rfilter>").radius, 1.5);
    const ReconstructionFilter gaussian = filter("<rfilter type=\"gaussian\"><float name=\"stddev\" value=\"0.25\"/></rfilter>");
    EXPECT_DOUBLE_EQ(gaussian.stddev, 0.25);
    EXPECT_DOUBLE_EQ(gaussian.radius, 1.0);
    const ReconstructionFilter lanczos = filter("<rfilter type=\"lanczos\"><integer name=\"lobes\" value=\"4\"/></rfilter>");
    EXPECT_EQ(lanczos.kind, Kind::lanczos);
    EXPECT_DOUBLE_EQ(lanczos.radius, 4.0);
    EXPECT_EQ(filter("<rfilter type=\"catmullrom\"/>").kind, Kind::catmullrom);
    const ReconstructionFilter mitchell =
        filter("<rfilter type=\"mitchell\"><float name=\"A\" value=\"0.2\"/><float name=\"B\" value=\"0.4\"/></rfilter>");
    EXPECT_EQ(mitchell.kind, Kind::mitchell);
    EXPECT_DOUBLE_EQ(mitchell.b, 0.2);
    EXPECT_DOUBLE_EQ(mitchell.c, 0.4);
    const ReconstructionFilter old =
        filter("<rfilter type=\"mitchell\"><float name=\"B\" value=\"0.2\"/><float name=\"C\" value=\"0.4\"/></rfilter>", "0.6.0");
    EXPECT_DOUBLE_EQ(old.b, 0.2);
    EXPECT_DOUBLE_EQ(old.c, 0.4);
}

TEST_F(LoadScene, SensorDefaultsAndOffsets) {
    const Scene scene = load_text(
        "<scene version=\"3.0.0\"><sensor type=\"perspective\"><float name=\"principal_point_offset_x\" value=\"0.1\"/>"
        "<float name=\"principal_point_offset_y\" value=\"-0.2\"/></sensor></scene>");
    EXPECT_EQ(scene.sensor.width, 768);
    EXPECT_EQ(scene.sensor.height, 576);
    EXPECT_EQ(scene.sensor.principal_point_offset, glm::dvec2(0.1, -0.2));
    EXPECT_EQ(scene.max_depth, -1);
    EXPECT_TRUE(scene.triangles.empty());
}

TEST_F(LoadScene, Integrators) {
    EXPECT_EQ(load_body("<integrator type=\"direct\"><integer name=\"emitter_samples\" value=\"4\"/></integrator>").max_depth, 2);
    EXPECT_EQ(load_body("<integrator type=\"path\"/>").max_depth, -1);
    EXPECT_EQ(load_body("<integrator type=\"path\"><integer name=\"max_depth\" value=\"-1\"/></integrator>").max_depth, -1);
    const Scene scene = load_body("<integrator type=\"volpath\"><integer name=\"max_depth\" value=\"8\"/></integrator>");
    EXPECT_EQ(scene.max_depth, 8);
    EXPECT_TRUE(has_warning(scene, "scene.xml:3: integrator type \"volpath\" is read as \"path\""));
}

TEST_F(LoadScene, BuiltInShapesFaceTheRightWay) {
    const Scene scene = load_body("<shape type=\"rectangle\"/><shape type=\"cube\"/><shape type=\"rectangle\" id=\"named\"/>");
    ASSERT_EQ(scene.shapes.size(), 3U);
    EXPECT_EQ(scene.shapes[0].id, "rectangle 1");
    EXPECT_EQ(scene.shapes[1].id, "cube 1");
    EXPECT_EQ(scene.shapes[2].id, "named");
    EXPECT_EQ(scene.shapes[1].kind, "cube");
    EXPECT_EQ(scene.shapes[1].first_triangle, 2U);
    EXPECT_EQ(scene.shapes[1].triangle_count, 12U);
    for (std::size_t t = 0; t < 2; ++t) EXPECT_EQ(face_vector(scene, t), glm::dvec3(0, 0, 4));
    glm::dvec3 sum(0.0);
    for (std::size_t t = 2; t < 14; ++t) {
        EXPECT_EQ(scene.triangles[t].shape, 1U);
        EXPECT_DOUBLE_EQ(glm::length(face_vector(scene, t)), 4.0);
        EXPECT_GT(glm::dot(face_vector(scene, t), scene.positions[scene.triangles[t].corners.x]), 0.0);
        sum += face_vector(scene, t);
    }
    EXPECT_EQ(sum, glm::dvec3(0.0));
    for (const glm::vec3 normal : scene.normals) EXPECT_EQ(normal, glm::vec3(0.0F));
}

TEST_F(LoadScene, SphereIsClosedRoundAndInPlace) {
    const Scene scene = load_body(
        "<shape type=\"sphere\"><point name=\"center\" x=\"1\" y=\"2\" z=\"3\"/><float name=\"radius\" value=\"2\"/>"
        "<transform name=\"to_world\"><scale value=\"0.5\"/></transform></shape>");
    const glm::dvec3 center(0.5, 1, 1.5);
    const auto place = [&](std::uint32_t i) { return std::tuple(scene.positions[i].x, scene.positions[i].y, scene.positions[i].z); };
    std::map<std::pair<std::tuple<double, double, double>, std::tuple<double, double, double>>, int> edges;
    double area = 0.0;
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
        const glm::uvec3 c = scene.triangles[t].corners;
        area += glm::length(face_vector(scene, t)) / 2;
        ASSERT_GT(glm::dot(face_vector(scene, t), scene.positions[c.x] - center), 0.0);
        for (int i = 0; i < 3; ++i) ++edges[{place(c[i]), place(c[(i + 1) % 3])}];
    }
    EXPECT_EQ(scene.triangles.size(), 1280U);
    for (const auto& [edge, count] : edges) {  // every edge once in each direction: watertight
        ASSERT_EQ(count, 1);
        ASSERT_EQ(edges.count({edge.second, edge.first}), 1U);
    }
    EXPECT_GT(area / (4 * M_PI), 1 - 0.005);  // as its header says
    EXPECT_LT(area / (4 * M_PI), 1.0);
    for (std::size_t i = 0; i < scene.positions.size(); ++i) {
        ASSERT_NEAR(glm::length(scene.positions[i] - center), 1.0, 1e-12);
        ASSERT_LT(glm::length(glm::dvec3(scene.normals[i]) - (scene.positions[i] - center)), 1e-6);
    }
}

TEST_F(LoadScene, MaterialsByReferenceNestingAndDefault) {
    const Scene scene = load_body(
        "<shape type=\"cube\"><ref name=\"bsdf\" id=\"later\"/></shape>"
        "<shape type=\"cube\"/><shape type=\"cube\"/>"
        "<bsdf type=\"twosided\" id=\"later\"><bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0.1, 0.2, 0.3\"/></bsdf></bsdf>"
        "<bsdf type=\"diffuse\" id=\"unused\"/><alias id=\"later\" as=\"other name\"/>"
        "<shape type=\"cube\"><ref id=\"other name\"/></shape>"
        "<shape type=\"cube\"><emitter type=\"area\"/></shape>"
        "<shape type=\"cube\"><bsdf type=\"twosided\"><ref id=\"unused\"/></bsdf></shape>");
    const auto material_of = [&](std::size_t shape) { return scene.triangles[scene.shapes[shape].first_triangle].material; };
    EXPECT_EQ(material_of(0), material_of(3));
    EXPECT_EQ(material_of(1), material_of(2));
    const SceneMaterial& named = scene.materials[material_of(0)];
    EXPECT_EQ(named.id, "later");
    EXPECT_TRUE(named.two_sided);
    EXPECT_EQ(named.albedo, glm::vec3(0.1F, 0.2F, 0.3F));
    EXPECT_EQ(scene.materials[material_of(1)].albedo, glm::vec3(0.5F));
    EXPECT_FALSE(scene.materials[material_of(1)].two_sided);
    EXPECT_EQ(scene.materials[material_of(4)].albedo, glm::vec3(0.0F));  // Mitsuba: emitters without a material are black
    EXPECT_EQ(scene.shapes[4].radiance, glm::vec3(1.0F));
    EXPECT_TRUE(scene.materials[material_of(5)].two_sided);
    EXPECT_EQ(scene.materials.size(), 4U);  // "unused" alone is not among them
}

TEST_F(LoadScene, Colours) {
    const auto albedo = [&](const std::string& colour) {
        return load_body("<shape type=\"cube\"><bsdf type=\"diffuse\">" + colour + "</bsdf></shape>").materials.at(0).albedo;
    };
    EXPECT_EQ(albedo("<rgb name=\"reflectance\" value=\"0.1 0.2 0.3\"/>"), glm::vec3(0.1F, 0.2F, 0.3F));
    EXPECT_EQ(albedo("<rgb name=\"reflectance\" value=\"0.25\"/>"), glm::vec3(0.25F));
    EXPECT_EQ(albedo("<rgb name=\"reflectance\" value=\"#ff0033\"/>"), glm::vec3(1.0F, 0.0F, 0.2F));
    EXPECT_EQ(albedo("<float name=\"reflectance\" value=\"0.25\"/>"), glm::vec3(0.25F));
    EXPECT_EQ(albedo("<spectrum name=\"reflectance\" value=\"0.25\"/>"), glm::vec3(0.25F));
    EXPECT_EQ(albedo("<spectrum name=\"reflectance\" value=\".1, .2, .3\"/>"), glm::vec3(0.1F, 0.2F, 0.3F));
    EXPECT_EQ(albedo("<rgb name=\"diffuseReflectance\" value=\"0.75\"/>"), glm::vec3(0.75F));
    expect_near(albedo("<srgb name=\"reflectance\" value=\"0.5, 0, 1\"/>"), {0.21404, 0, 1}, 1e-5);
    expect_near(albedo("<srgb name=\"reflectance\" value=\"#8000FF\"/>"), {0.21586, 0, 1}, 1e-5);
    expect_near(albedo("<spectrum name=\"reflectance\" value=\"300:0.25, 900:0.25\"/>"), glm::dvec3(0.25), 1e-7);
    // all light below 500 nm: blue
    const glm::vec3 blue = albedo("<spectrum name=\"reflectance\" value=\"380:1 499:1 500:0 780:0\"/>");
    EXPECT_GT(blue.z, 0.8F);
    EXPECT_LT(blue.x, 0.3F);
}

/// A spectrum of one number emits alike at all wavelengths, which is not white; rgb is the colour that it says. Mitsuba 3's values.
TEST_F(LoadScene, UniformSpectraEmitIlluminantE) {
    const auto radiance = [&](const std::string& colour) {
        return load_body("<shape type=\"cube\"><emitter type=\"area\">" + colour + "</emitter></shape>").shapes.at(0).radiance;
    };
    expect_near(radiance("<spectrum name=\"radiance\" value=\"2\"/>"), {2.410, 1.897, 1.817}, 2e-3);
    EXPECT_EQ(radiance("<rgb name=\"radiance\" value=\"2\"/>"), glm::vec3(2.0F));
    EXPECT_EQ(radiance("<spectrum name=\"radiance\" value=\"1, 2, 3\"/>"), glm::vec3(1.0F, 2.0F, 3.0F));
}

TEST_F(LoadScene, PointLights) {
    const Scene scene = load_body(
        "<emitter type=\"point\"><point name=\"position\" x=\"1\" y=\"2\" z=\"3\"/><rgb name=\"intensity\" value=\"4, 5, 6\"/></emitter>"
        "<emitter type=\"point\"><transform name=\"toWorld\"><translate x=\"7\"/></transform></emitter>");
    ASSERT_EQ(scene.point_lights.size(), 2U);
    EXPECT_EQ(scene.point_lights[0].position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(scene.point_lights[0].intensity, glm::vec3(4, 5, 6));
    EXPECT_EQ(scene.point_lights[1].position, glm::dvec3(7, 0, 0));
    EXPECT_EQ(scene.point_lights[1].intensity, glm::vec3(1));
}

TEST_F(LoadScene, DefaultsAndDefines) {
    const std::string text =
        "<scene version=\"3.0.0\"><default name=\"res\" value=\"10\"/><default name=\"resx\" value=\"${res}\"/></scene>";
    EXPECT_NE(error_of(text).find("is not defined"), std::string::npos);
    const std::string body =
        "<default name=\"a\" value=\"0.25\"/><default name=\"ab\" value=\"0.5\"/><default name=\"both\" value=\"$a, $ab, $a\"/>"
        "<shape type=\"cube\"><bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"$both\"/></bsdf></shape>";
    EXPECT_EQ(load_body(body).materials.at(0).albedo, glm::vec3(0.25F, 0.5F, 0.25F));
    LoadOptions options;
    options.defines = {{"a", "0.75"}, {"unknown", "1"}};
    const Scene scene = load_body(body, options);
    EXPECT_EQ(scene.materials.at(0).albedo, glm::vec3(0.75F, 0.5F, 0.75F));
    EXPECT_TRUE(has_warning(scene, "does not use $unknown"));
}

TEST_F(LoadScene, MeshesFromFiles) {
    write("meshes/m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nvn 0 0 3\nvn 0 0 -1\nf 1//1 2//1 3//1\nf 1//1 2//1 3//1\n");
    write("m.ply",
          "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
          "property list uchar int vertex_indices\nend_header\n9 9 9\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n");
    const Scene scene = load_body(
        "<shape type=\"obj\"><string name=\"filename\" value=\"meshes/m.obj\"/></shape>"
        "<shape type=\"obj\"><string name=\"filename\" value=\"./meshes/m.obj\"/><boolean name=\"faceNormals\" value=\"true\"/></shape>"
        "<shape type=\"ply\"><string name=\"filename\" value=\"m.ply\"/></shape>");
    ASSERT_EQ(scene.triangles.size(), 5U);
    EXPECT_EQ(scene.positions.size(), 9U);  // only vertices in use
    EXPECT_EQ(scene.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(scene.normals[3], glm::vec3(0));
    EXPECT_EQ(scene.normals[8], glm::vec3(0));
    EXPECT_EQ(face_vector(scene, 4), glm::dvec3(0, 0, 1));
}

TEST_F(LoadScene, VertexNormalsSayWhichSideIsTheFront) {
    write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 -1\nvn 0 0 0\nf 1//1 2//1 3//2\n");
    const std::string shape = "<shape type=\"obj\"><string name=\"filename\" value=\"m.obj\"/>";
    const Scene scene = load_body(shape + "</shape>" + shape + "<boolean name=\"face_normals\" value=\"true\"/></shape>");
    EXPECT_EQ(face_vector(scene, 0), glm::dvec3(0, 0, -1));
    EXPECT_EQ(face_vector(scene, 1), glm::dvec3(0, 0, 1));
    EXPECT_EQ(scene.normals[0], glm::vec3(0, 0, -1));
    EXPECT_EQ(scene.normals[1], glm::vec3(0));  // corners 2 and 3 have changed places
    EXPECT_TRUE(has_warning(scene, "1 triangles wound against their vertex normals"));
}

TEST_F(LoadScene, ZeroAreaTrianglesAreDroppedAndCounted) {
    write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 1e6 1 0\nf 1 2 3\nf 1 2 4\nf 1 1 2\nf 1 5 2\n");
    const Scene scene = load_body("<shape type=\"obj\" id=\"m\"><string name=\"filename\" value=\"m.obj\"/></shape>");
    EXPECT_EQ(scene.triangles.size(), 2U);  // the sliver of 1e6 : 1 stays
    EXPECT_EQ(scene.shapes[0].triangle_count, 2U);
    EXPECT_EQ(scene.positions.size(), 4U);  // no vertex only of dropped triangles
    EXPECT_TRUE(has_warning(scene, "scene.xml:3: shape type \"obj\" \"m\": 2 triangles of zero area left out"));
}

TEST_F(LoadScene, UnknownParametersAreWarnings) {
    const Scene scene = load_body(
        "<shape type=\"sphere\">\n<float name=\"radus\" value=\"2\"/></shape>\n"
        "<emitter type=\"point\"><float name=\"zzz\" value=\"2\"/></emitter>");
    ASSERT_EQ(scene.warnings.size(), 2U);
    EXPECT_NE(scene.warnings[0].find("scene.xml:4: shape type \"sphere\" has no parameter \"radus\": ignored; did you mean \"radius\"?"),
              std::string::npos)
        << scene.warnings[0];
    EXPECT_NE(scene.warnings[1].find("scene.xml:5: emitter type \"point\" has no parameter \"zzz\": ignored"), std::string::npos);
    EXPECT_EQ(scene.warnings[1].find("did you mean"), std::string::npos);
}

TEST_F(LoadScene, TheProjectsScenesLoadWithoutWarnings) {
    for (const char* name : {"cornell-box", "furnace", "lit-wall", "two-rooms"}) {
        const Scene scene = load_scene(std::string(PENCIL_SOURCE_DIR) + "/scenes/" + name + ".xml");
        EXPECT_GT(scene.triangles.size(), 0U) << name;
        EXPECT_TRUE(scene.warnings.empty()) << name << ": " << scene.warnings[0];
    }
    LoadOptions options;
    options.defines = {{"partition", "partition-closed.obj"}, {"max_depth", "3"}};
    const Scene closed = load_scene(std::string(PENCIL_SOURCE_DIR) + "/scenes/two-rooms.xml", options);
    EXPECT_EQ(closed.max_depth, 3);
    EXPECT_EQ(closed.shapes.at(1).triangle_count, 2U);
}

TEST_F(LoadScene, ClosedBoxesFaceInwardAndShareTheirCorners) {
    for (const char* name : {"furnace", "lit-wall"}) {
        const Scene scene = load_scene(std::string(PENCIL_SOURCE_DIR) + "/scenes/" + name + ".xml");
        const glm::dvec3 middle = std::string(name) == "furnace" ? glm::dvec3(0.0) : glm::dvec3(0.5);
        glm::dvec3 sum(0.0);
        for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
            EXPECT_GT(glm::dot(face_vector(scene, t), middle - scene.positions[scene.triangles[t].corners.x]), 0.0)
                << name << " triangle " << t;
            sum += face_vector(scene, t);
        }
        EXPECT_EQ(sum, glm::dvec3(0.0)) << name;
        for (const glm::dvec3 p : scene.positions)
            for (int i = 0; i < 3; ++i) EXPECT_EQ(std::abs(p[i] - middle[i]), std::string(name) == "furnace" ? 1.0 : 0.5) << name;
    }
}

}  // namespace
}  // namespace pencil::test
