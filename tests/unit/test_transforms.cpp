// Transforms of scene files against matrices worked out by hand; a point light shows where the origin, a rectangle where its normal goes.
#include <cmath>
#include <glm/geometric.hpp>

#include "unit/scene_fixture.h"

namespace pencil::test {
namespace {

constexpr double rounding = 1e-12;  // of a few operations on numbers near 1

class Transforms : public SceneTest {
protected:
    glm::dvec3 origin_of(const std::string& operations) const {
        const Scene scene = load_body("<emitter type=\"point\"><transform name=\"to_world\">" + operations + "</transform></emitter>");
        return scene.point_lights.at(0).position;
    }
    Scene shape(const std::string& type, const std::string& operations, const std::string& more = "") const {
        return load_body("<shape type=\"" + type + "\">" + more + "<transform name=\"toWorld\">" + operations + "</transform></shape>");
    }
    glm::dmat4 camera(const std::string& operations) const {
        return load_text("<scene version=\"3.0.0\"><sensor type=\"perspective\"><transform name=\"to_world\">" + operations +
                         "</transform></sensor></scene>")
            .sensor.to_world;
    }
};

TEST_F(Transforms, EachOperationMultipliesFromTheLeft) {
    expect_near(origin_of("<translate x=\"1\" y=\"2\" z=\"3\"/><scale value=\"2\"/>"), {2, 4, 6}, rounding);
    expect_near(origin_of("<scale value=\"2\"/><translate x=\"1\" y=\"2\" z=\"3\"/>"), {1, 2, 3}, rounding);
    expect_near(origin_of("<translate value=\"1, 2, 3\"/><scale x=\"10\" z=\"-1\"/>"), {10, 2, -3}, rounding);
    expect_near(origin_of("<translate value=\"1 2 3\"/><scale value=\"2, 3 4\"/>"), {2, 6, 12}, rounding);
    expect_near(origin_of("<translate x=\"+1.5e1\"/>"), {15, 0, 0}, rounding);
}

TEST_F(Transforms, RotationsTurnCounterClockwiseSeenAgainstTheAxis) {
    expect_near(origin_of("<translate x=\"1\"/><rotate z=\"1\" angle=\"90\"/>"), {0, 1, 0}, 0.0);
    expect_near(origin_of("<translate y=\"1\"/><rotate x=\"2\" angle=\"90\"/>"), {0, 0, 1}, 0.0);
    expect_near(origin_of("<translate z=\"1\"/><rotate y=\"1\" angle=\"-270\"/>"), {1, 0, 0}, 0.0);
    expect_near(origin_of("<translate x=\"1\"/><rotate z=\"1\" angle=\"30\"/>"), {std::sqrt(3.0) / 2, 0.5, 0}, rounding);
    expect_near(origin_of("<translate x=\"1\"/><rotate value=\"1, 1, 1\" angle=\"120\"/>"), {0, 1, 0}, rounding);
    expect_near(origin_of("<translate value=\"1 2 3\"/><rotate value=\"0 0 1\" angle=\"180\"/>"), {-1, -2, 3}, 0.0);
}

TEST_F(Transforms, MatricesAreWrittenRowByRow) {
    expect_near(origin_of("<translate value=\"1, 1, 1\"/><matrix value=\"1 2 3 4  5 6 7 8  9 10 12 12  0 0 0 1\"/>"), {10, 26, 43},
                rounding);
    expect_near(origin_of("<translate value=\"1, 0, 2\"/><matrix value=\"1,2,3, 4,5,6, 7,8,10\"/>"), {7, 16, 27}, rounding);
}

TEST_F(Transforms, LookatPutsLeftUpAndForwardIntoTheColumns) {
    const glm::dmat4 m = camera("<lookat origin=\"278, 273, -800\" target=\"278, 273, -799\" up=\"0, 1, 0\"/>");
    EXPECT_EQ(m[0], glm::dvec4(1, 0, 0, 0));
    EXPECT_EQ(m[1], glm::dvec4(0, 1, 0, 0));
    EXPECT_EQ(m[2], glm::dvec4(0, 0, 1, 0));
    EXPECT_EQ(m[3], glm::dvec4(278, 273, -800, 1));
    // Looking along -z with y up, left is -x.
    for (const char* tag : {"lookat", "look_at", "lookAt"}) {
        const glm::dmat4 back = camera(std::string("<") + tag + " origin=\"0 0 5\" target=\"0 0 0\" up=\"0 2 0\"/>");
        EXPECT_EQ(back[0], glm::dvec4(-1, 0, 0, 0));
        EXPECT_EQ(back[1], glm::dvec4(0, 1, 0, 0));
        EXPECT_EQ(back[2], glm::dvec4(0, 0, -1, 0));
    }
    const glm::dmat4 down = camera("<lookat origin=\"1, 1, 1\" target=\"1, 0, 0\" up=\"0, 1, 0\"/>");
    const double h = std::sqrt(0.5);
    expect_near(glm::dvec3(down[0]), {-1, 0, 0}, rounding);  // cross((0, 1, 0), (0, -h, -h))
    expect_near(glm::dvec3(down[1]), {0, h, -h}, rounding);
    expect_near(glm::dvec3(down[2]), {0, -h, -h}, rounding);
}

TEST_F(Transforms, UpParallelToTheViewIsReplacedAndTold) {
    const std::string sensor =
        "<scene version=\"3.0.0\"><sensor type=\"perspective\"><transform name=\"to_world\">"
        "<lookat origin=\"0, 1, 0\" target=\"0, 0, 0\" up=\"0, 1, 0\"/></transform></sensor></scene>";
    const Scene scene = load_text(sensor);
    EXPECT_TRUE(has_warning(scene, "scene.xml:1: <lookat>: up is parallel to the view"));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(glm::length(scene.sensor.to_world[i]), 1.0, rounding);
    EXPECT_EQ(glm::dvec3(scene.sensor.to_world[2]), glm::dvec3(0, -1, 0));
}

TEST_F(Transforms, MirroringKeepsTheFront) {
    // The normal of a rectangle is +z; mirrored in x it is still +z, mirrored in z it is -z. The winding must agree with it.
    Scene scene = shape("rectangle", "<scale x=\"-1\"/>");
    for (std::size_t t = 0; t < 2; ++t) expect_near(face_vector(scene, t), {0, 0, 4}, rounding);
    scene = shape("rectangle", "<scale z=\"-1\"/>");
    for (std::size_t t = 0; t < 2; ++t) expect_near(face_vector(scene, t), {0, 0, -4}, rounding);
    scene = shape("rectangle", "<scale x=\"-2\" y=\"-3\"/>");
    for (std::size_t t = 0; t < 2; ++t) expect_near(face_vector(scene, t), {0, 0, 24}, rounding);
    scene = shape("cube", "<matrix value=\"0 1 0 0  1 0 0 0  0 0 1 0  0 0 0 1\"/>");  // swaps x and y: a mirror
    for (std::size_t t = 0; t < 12; ++t)
        EXPECT_GT(glm::dot(face_vector(scene, t), scene.positions[scene.triangles[t].corners.x]), 0.0) << "triangle " << t;
}

TEST_F(Transforms, FlipNormalsTurnsTheFront) {
    for (const char* name : {"flip_normals", "flipNormals"}) {
        const std::string flip = std::string("<boolean name=\"") + name + "\" value=\"true\"/>";
        Scene scene = shape("rectangle", "<scale x=\"-1\"/>", flip);
        for (std::size_t t = 0; t < 2; ++t) expect_near(face_vector(scene, t), {0, 0, -4}, rounding);
        scene = shape("sphere", "<scale value=\"1\"/>", flip);
        for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
            const std::uint32_t corner = scene.triangles[t].corners.x;
            ASSERT_LT(glm::dot(face_vector(scene, t), scene.positions[corner]), 0.0);
            ASSERT_LT(glm::dot(glm::dvec3(scene.normals[corner]), scene.positions[corner]), 0.0);
        }
    }
}

TEST_F(Transforms, NormalsGoByTheInverseTranspose) {
    // The ellipsoid (x/2)^2 + y^2 + z^2 = 1, mirrored in y besides: its normal is along the gradient (x/4, y, z).
    const Scene scene = shape("sphere", "<scale x=\"2\" y=\"-1\"/>");
    for (std::size_t i = 0; i < scene.positions.size(); ++i) {
        const glm::dvec3 p = scene.positions[i];
        const glm::dvec3 expected = glm::normalize(glm::dvec3(p.x / 4, p.y, p.z));
        ASSERT_LT(glm::length(glm::dvec3(scene.normals[i]) - expected), 1e-6);  // single precision
    }
    for (std::size_t t = 0; t < scene.triangles.size(); ++t)
        ASSERT_GT(glm::dot(face_vector(scene, t), glm::dvec3(scene.normals[scene.triangles[t].corners.x])), 0.0);
}

/// As planes are exported. The winding tells the front.
TEST_F(Transforms, SurfacesMayBeFlattened) {
    const auto shape = [](const std::string& type, const std::string& operations) {
        return "<shape type=\"" + type + "\"><transform name=\"to_world\">" + operations + "</transform></shape>";
    };
    const Scene scene = load_body(shape("rectangle", "<scale x=\"2\" y=\"3\" z=\"0\"/><rotate x=\"1\" y=\"0.3\" angle=\"77\"/>"));
    ASSERT_EQ(scene.triangles.size(), 2U);
    const Scene full = load_body(shape("rectangle", "<scale x=\"2\" y=\"3\"/><rotate x=\"1\" y=\"0.3\" angle=\"77\"/>"));
    for (std::size_t i = 0; i < 2; ++i) expect_near(face_vector(scene, i), face_vector(full, i), 1e-12);
    EXPECT_TRUE(scene.warnings.empty());
    expect_error(shape("cube", "<scale z=\"0\"/>"), 3, "the cube is flattened, so that its two sides lie in one place; use a rectangle");
    EXPECT_TRUE(has_warning(load_body(shape("rectangle", "<scale x=\"0\"/>")), "has no triangles"));
    expect_error(shape("rectangle", "<scale x=\"0\" y=\"0\"/>"), 3, "leaves a line or a point of the shape; is a scale 0?");
    expect_error(shape("rectangle", "<matrix value=\"1 2 3 0 2 4 6 0 3 6 9 0 0 0 0 1\"/>"), 3, "leaves a line or a point");
}

TEST_F(Transforms, BadTransformsNameTheirLine) {
    const auto light = [](const std::string& operation) {
        return "<emitter type=\"point\"><transform name=\"to_world\">\n" + operation + "</transform></emitter>\n";
    };
    expect_error(light("<lookat origin=\"1,1,1\" target=\"1 1 1\" up=\"0,1,0\"/>"), 4, "origin and target are the same point");
    expect_error(light("<lookat origin=\"1,1\" target=\"1 1 1\"/>"), 4, "origin=\"x, y, z\"");
    expect_error(light("<lookat target=\"1 1 1\"/>"), 4, "origin");
    expect_error(light("<matrix value=\"1 0 0 0\"/>"), 4, "4 numbers, not 16");
    expect_error(light("<matrix value=\"1 0 0 0 0 1 0 0 0 0 1 0 0 0 0.5 1\"/>"), 4, "perspective");
    expect_error(light("<matrix value=\"1 0 0 0 0 nan 0 0 0 0 1 0 0 0 0 1\"/>"), 4, "not a finite number");
    expect_error(light("<matrix value=\"1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 x\"/>"), 4, "\"x\" is not a number");
    EXPECT_TRUE(has_warning(load_body(light("<rotate angle=\"10\"/>")), "scene.xml:4: <rotate> has no axis: it turns nothing"));
    expect_error(light("<rotate x=\"1\"/>"), 4, "angle");
    expect_error(light("<scale value=\"1,5\"/>"), 4, "<scale>");
    expect_error(light("<translate x=\"1,5\"/>"), 4, "\"1,5\" is not a number (the decimal mark is a point)");
    expect_error(light("<translate x=\"1\" value=\"2\"/>"), 4, "both value and x");
    expect_error(light("<scale value=\"1e200\"/><scale value=\"1e200\"/>"), 4, "overflows");
    expect_error(light("<shear x=\"1\"/>"), 4, "<shear> is not known");
    expect_error(light("<rgb name=\"a\" value=\"1\"/>"), 4, "<rgb> is not a transform");
    expect_error(light("<scale x=\"0\"/>"), 3, "singular");
    expect_error(light("<matrix value=\"1 2 3 0 2 4 6 0 0 0 1 0 0 0 0 1\"/>"), 3, "singular");
    EXPECT_TRUE(has_warning(load_body(light("<translate w=\"1\"/>")), "scene.xml:4: <translate> has no attribute \"w\""));
}

}  // namespace
}  // namespace pencil::test
