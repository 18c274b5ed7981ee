// Light from far away and spots, textures and blends, other cameras: the surface method against the path tracer and against what is known.
#include <glm/gtc/packing.hpp>

#include "scenes/against_paths.h"

namespace {

using namespace pencil;
using namespace pencil::test;

SceneMaterial with_model(int model) {
    SceneMaterial m;
    m.model = model;
    m.albedo = glm::vec3(1.0F);
    return m;
}

Scene thing_in_the_open(const SceneMaterial& material) {
    Scene scene;
    add_box(scene, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, Surface{glm::vec3(1.0F)}, false);
    for (SceneMaterial& m : scene.materials) m = material;
    scene.environment.emplace();
    look_at(scene, {1.0, 1.2, -1.8}, {0, 0, 0}, {0, 1, 0}, 40.0, compared_size, compared_size);
    return scene;
}

/// What loses no light cannot be seen in front of an even sky.
TEST(FarLight, WhiteThingsVanishInAnEvenSky) {
    SceneMaterial mirror = with_model(MATERIAL_CONDUCTOR), varnish = with_model(MATERIAL_PLASTIC), pane = with_model(MATERIAL_DIELECTRIC);
    mirror.perfect_mirror = varnish.nonlinear = pane.thin = true;
    for (const SceneMaterial& m : {with_model(MATERIAL_DIFFUSE), mirror, varnish, pane}) {
        SCOPED_TRACE("model " + std::to_string(m.model));
        RenderOptions options = compared_options();
        options.target_error = 1e6;
        expect_uniform(layer(render_layers(thing_in_the_open(m), options), ""), 1.0, 5e-3);
    }
    // Of glass what goes round inside ends by chance.
    RenderOptions options = compared_options();
    const dvec3 mean = mean_radiance(layer(render_layers(thing_in_the_open(with_model(MATERIAL_DIELECTRIC)), options), ""));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], 1.0, 0.01);
}

/// A floor with a wall, seen from above, of materials that a test may change: 0 is the floor's.
Scene court() {
    Scene scene;
    add_quad(scene, "floor", {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, Surface{glm::vec3(0.6F, 0.5F, 0.4F), glm::vec3(0.0F), true});
    add_box(scene, {-0.3, 0.0, -0.3}, {0.2, 0.5, 0.2}, Surface{glm::vec3(0.3F, 0.5F, 0.7F)}, false);
    look_at(scene, {0.8, 1.4, -1.6}, {0, 0.1, 0}, {0, 1, 0}, 45.0, compared_size, compared_size);
    return scene;
}

/// A dim sky with a small sun.
Environment sunny() {
    Environment e;
    e.width = 32;
    e.height = 16;
    for (int y = 0; y < e.height; ++y)
        for (int x = 0; x < e.width; ++x) e.texels.emplace_back(y < 8 ? glm::vec3(0.3F, 0.4F, 0.6F) : glm::vec3(0.1F));
    e.texels[5 * 32 + 7] = glm::vec3(200.0F, 180.0F, 150.0F);
    return e;
}

TEST(FarLight, ASkyWithASun) {
    Scene scene = court();
    scene.environment = sunny();
    expect_path_tracers(scene, 0.01);
}

TEST(FarLight, ASunOnGloss) {
    Scene scene = court();
    scene.environment = sunny();
    SceneMaterial& floor = scene.materials[0];
    floor.model = MATERIAL_PLASTIC;
    floor.alpha = glm::vec2(0.2F);
    expect_path_tracers(scene, 0.01);
}

TEST(FarLight, ParallelLightAndASpot) {
    Scene scene = court();
    scene.directional_lights.push_back({glm::normalize(dvec3(0.3, -1.0, 0.5)), glm::vec3(1.0F, 0.8F, 0.5F)});
    PointLight spot{{0.9, 1.2, 0.9}, glm::vec3(4.0F, 3.0F, 5.0F)};
    spot.is_spot = true;
    spot.cutoff = 30;
    spot.beam_width = 15;
    const dvec3 axis = glm::normalize(dvec3(-0.9, -1.2, -0.9)), side = glm::normalize(glm::cross(axis, dvec3(0, 1, 0)));
    spot.to_world = glm::dmat3(side, glm::cross(axis, side), axis);
    scene.point_lights.push_back(spot);
    expect_path_tracers(scene, 0.01);
}

/// A bitmap on the floor of the court, the corners of which have coordinates.
void cover_floor(Scene& scene, const Texture& texture) {
    scene.textures.push_back(texture);
    scene.uvs.assign(scene.positions.size(), glm::vec2(0.0F));
    for (std::size_t i = 0; i < 6; ++i) scene.uvs[i] = 0.5F + 0.5F * glm::vec2(scene.positions[i].x, scene.positions[i].z);
}

Texture stripes() {
    Texture texture;
    texture.width = 8;
    texture.height = 2;
    for (int i = 0; i < 16; ++i)
        texture.texels.push_back(glm::packHalf(glm::vec4(i % 2, 0.2F + 0.05F * static_cast<float>(i), 0.9F, i % 3 == 0)));
    return texture;
}

TEST(Textures, ColourOfTheFloor) {
    Scene scene = court();
    cover_floor(scene, stripes());
    scene.materials[0].albedo_texture = 0;
    scene.environment.emplace();
    expect_path_tracers(scene, 0.01);
}

TEST(Textures, AMaskLetsTheSkyThrough) {
    Scene scene = court();
    cover_floor(scene, stripes());
    SceneMaterial mask = with_model(MATERIAL_BLEND);
    const auto count = static_cast<std::int64_t>(scene.materials.size());
    scene.materials.push_back(with_model(MATERIAL_PASS));
    scene.materials.push_back(scene.materials[0]);
    mask.blended[0] = count;
    mask.blended[1] = count + 1;
    mask.weight = 1.0F;
    mask.weight_texture = 0;
    mask.weight_is_opacity = mask.two_sided = true;
    scene.materials.push_back(mask);
    for (Triangle3& t : scene.triangles)
        if (t.material == 0) t.material = static_cast<std::uint32_t>(count + 2);
    scene.environment = sunny();
    expect_path_tracers(scene, 0.01);
}

TEST(Cameras, ParallelRaysAndALens) {
    Scene scene = court();
    scene.environment.emplace();
    scene.directional_lights.push_back({glm::normalize(dvec3(0.3, -1.0, 0.5)), glm::vec3(1.0F, 0.8F, 0.5F)});
    Scene lens = scene;
    lens.sensor.aperture_radius = 0.1;
    lens.sensor.focus_distance = 1.8;
    expect_path_tracers(lens, 0.01);
    scene.sensor.orthographic = true;
    expect_path_tracers(scene, 0.01);
}

}  // namespace
