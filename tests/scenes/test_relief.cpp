// Surfaces whose shading normals lean out of their planes: no light comes to them through the plane, neither from lamps nor from the sky.
#include <glm/gtc/packing.hpp>

#include "scenes/against_paths.h"

namespace {

using namespace pencil;
using namespace pencil::test;

enum class Leans { by_texture, by_vertex };
enum class Behind { sun, sky };

/// A wall with its back to the light, whose normals lean towards it, and the floor before it, which is in the sun.
Scene wall_against_light(Leans leans, Behind behind, bool varnished) {
    Scene scene;
    add_quad(scene, "floor", {-1, 0, -2}, {0, 0, 2}, {2, 0, 0}, Surface{glm::vec3(0.4F), glm::vec3(0.0F), true});
    add_quad(scene, "wall", {1, 0, 0}, {-2, 0, 0}, {0, 1, 0}, Surface{glm::vec3(0.6F, 0.5F, 0.4F), glm::vec3(0.0F), true});
    if (varnished) {
        scene.materials[0].model = MATERIAL_PLASTIC;
        scene.materials[0].alpha = glm::vec2(0.2F);
    }
    const glm::vec3 lean = glm::normalize(glm::vec3(0.2F, 0.7F, -0.7F));
    if (leans == Leans::by_vertex) {
        for (std::size_t i = 6; i < scene.normals.size(); ++i) scene.normals[i] = lean;
    } else {
        for (const dvec3& p : scene.positions) scene.uvs.emplace_back(p.x, p.y);
        Texture slope;
        slope.width = slope.height = 1;
        slope.texels = {glm::packHalf(glm::vec4(0.5F + 0.5F * glm::vec3(lean.x, lean.y, -lean.z), 1.0F))};
        scene.textures.push_back(slope);
        scene.materials[1].normal_texture = 0;
    }
    if (behind == Behind::sun)
        scene.directional_lights.push_back({glm::normalize(dvec3(-0.2, -1.0, -0.7)), glm::vec3(3.0F)});
    else
        scene.environment.emplace();
    look_at(scene, {0.3, 0.9, -2.2}, {0, 0.4, 0}, {0, 1, 0}, 50.0, compared_size, compared_size);
    return scene;
}

/// A floor in the sun with a normal map, of which some coordinates are mirrored: by each convention for y.
TEST(Relief, OfMirroredCoordinates) {
    for (const bool y_against_v : {false, true}) {
        SCOPED_TRACE(y_against_v ? "up in pictures" : "a left turn from u");
        Scene scene;
        for (int k = 0; k < 2; ++k) add_quad(scene, "floor", {k - 1, 0, -1}, {0, 0, 2}, {1, 0, 0}, Surface{glm::vec3(0.6F)});
        for (const dvec3& p : scene.positions) scene.uvs.emplace_back(scene.uvs.size() < 6 ? p.x : -p.x, p.z);
        Texture slope;
        slope.width = slope.height = 1;
        slope.texels = {glm::packHalf(glm::vec4(0.5F + 0.5F * glm::normalize(glm::vec3(0.3F, 0.5F, 0.7F)), 1.0F))};
        scene.textures.push_back(slope);
        for (SceneMaterial& m : scene.materials) {
            m.normal_texture = 0;
            m.y_against_v = y_against_v;
        }
        scene.directional_lights.push_back({glm::normalize(dvec3(-0.3, -1.0, -0.4)), glm::vec3(3.0F)});
        for (const double x : {-0.5, 0.5}) {
            look_at(scene, {x, 1, 0}, {x, 0, 0}, {0, 0, 1}, 20.0, compared_size, compared_size);
            expect_path_tracers(scene, 0.002, 64);
        }
    }
}

class ReliefWalls : public testing::TestWithParam<std::tuple<Leans, Behind, bool>> {};

TEST_P(ReliefWalls, LetNoLightThrough) {
    const auto [leans, behind, varnished] = GetParam();
    expect_path_tracers(wall_against_light(leans, behind, varnished), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Relief, ReliefWalls,
                         testing::Values(std::tuple(Leans::by_texture, Behind::sun, false),
                                         std::tuple(Leans::by_texture, Behind::sky, true),
                                         std::tuple(Leans::by_vertex, Behind::sky, true)));

}  // namespace
