// Scenes of mirrors, glass, masks and relief whose images are known in closed form. All estimators of light must agree on them.
#include <glm/gtc/packing.hpp>

#include "reference/bsdf.h"
#include "reference/fresnel.h"
#include "reference_renderer/traced.h"

namespace {

using namespace pencil;
using namespace pencil::test;

const Surface black{glm::vec3(0.0F), glm::vec3(0.0F), false}, white_lamp{glm::vec3(0.0F), glm::vec3(1.0F), false};

SceneMaterial scene_material(int model) {
    SceneMaterial m;
    m.model = model;
    m.eta = glm::vec3(1.5F);
    return m;
}

/// Gives the shape that was added last this material.
void paint(Scene& scene, const SceneMaterial& material) { scene.materials.back() = material; }

/// A sphere of radius 1/2 about the origin that is seen from outside, with normals if it is to be `smooth`.
void add_ball(Scene& scene, const SceneMaterial& material, bool smooth) {
    std::vector<Face> faces = inward_sphere(0.5, 40);
    for (Face& f : faces) std::swap(f[1], f[2]);
    add_shape(scene, "ball", faces, black);
    paint(scene, material);
    if (!smooth) return;
    const std::size_t first = scene.positions.size() - 3 * faces.size();
    for (std::size_t i = first; i < scene.positions.size(); ++i) scene.normals[i] = glm::vec3(glm::normalize(scene.positions[i]));
}

/// Three ways to say that radiance 1 comes from everywhere.
std::vector<std::pair<std::string, Scene>> all_bright() {
    std::vector<std::pair<std::string, Scene>> scenes(3);
    scenes[0].first = "walls";
    add_box(scenes[0].second, dvec3(-4), dvec3(4), white_lamp);
    scenes[1].first = "constant";
    scenes[1].second.environment.emplace();
    scenes[2].first = "map";
    Environment& map = scenes[2].second.environment.emplace();
    map.width = 7;
    map.height = 5;
    map.texels.assign(35, glm::vec3(1.0F));
    for (auto& [name, scene] : scenes) look_at(scene, {0, 0, 2}, dvec3(0), {0, 1, 0}, 30.0, 16, 16);
    return scenes;
}

TEST(Materials, WhatLosesNothingIsInvisibleInAWhiteFurnace) {
    SceneMaterial glass = scene_material(MATERIAL_DIELECTRIC), pane = glass, mirror = scene_material(MATERIAL_CONDUCTOR);
    pane.thin = true;
    mirror.perfect_mirror = true;
    for (auto& [name, scene] : all_bright())
        for (const SceneMaterial& material : {glass, pane, mirror, scene_material(MATERIAL_PASS)}) {
            Scene with_ball = scene;
            add_ball(with_ball, material, false);
            for (const Layer& image : {layer(trace(with_ball, 64).layers, "")}) expect_uniform(image, 1.0, 1e-4);
        }
}

/// A plane of any material under even light is as bright as its albedo into the direction of the eye, whatever samples find that light.
TEST(Materials, EveryLightFindsTheAlbedo) {
    SceneMaterial metal = scene_material(MATERIAL_CONDUCTOR), glass = scene_material(MATERIAL_DIELECTRIC),
                  oren = scene_material(MATERIAL_ROUGH_DIFFUSE), phong = scene_material(MATERIAL_PHONG),
                  disney = scene_material(MATERIAL_PRINCIPLED);
    metal.alpha = {0.1F, 0.4F};
    metal.eta = glm::vec3(0.2F);
    metal.k = glm::vec3(3.9F);
    glass.alpha = glm::vec2(0.3F);
    oren.alpha = glm::vec2(0.5F);
    phong.specular = glm::vec3(0.4F);
    disney.alpha = glm::vec2(0.3F);
    disney.principled.clearcoat = 1.0F;
    disney.principled.metallic = 0.5F;
    const double tilt = 0.6;  // of the eye, from the normal
    for (auto& [name, scene] : all_bright())
        for (const SceneMaterial& material : {metal, glass, oren, phong, disney}) {
            SurfaceMaterial m;
            m.model = material.model;
            m.albedo = material.albedo;
            m.specular = material.specular;
            m.eta = material.eta;
            m.k = material.k;
            m.alpha = material.alpha;
            m.principled = material.principled;
            double expected = 0;
            const glm::vec3 omega_o(0.0F, -std::sin(tilt), std::cos(tilt));
            constexpr int rows = 800, columns = 400;
            for (int i = 0; i < rows; ++i)
                for (int k = 0; k < columns; ++k) {
                    const double z = 2 * (i + 0.5) / rows - 1, phi = 2 * ref::pi * (k + 0.5) / columns, r = std::sqrt(1 - z * z);
                    expected += evaluate(m, omega_o, glm::vec3(r * std::cos(phi), r * std::sin(phi), z)).x * 4 * ref::pi / (rows * columns);
                }
            Scene lit = scene;
            add_quad(lit, "plane", {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, black);
            paint(lit, material);
            lit.uvs.assign(lit.positions.size(), glm::vec2(0.0F));  // u runs along x, which is what anisotropy goes by
            for (std::size_t i = lit.positions.size() - 6; i < lit.positions.size(); ++i) lit.uvs[i] = glm::vec2(lit.positions[i]);
            look_at(lit, {0, -std::sin(tilt), std::cos(tilt)}, dvec3(0), {0, 1, 0}, 0.2, 8, 8);
            const Estimate e = mean_of_image(trace(lit, 512));
            EXPECT_NEAR(e.mean, expected, 3 * e.error + 2e-3) << name << ", model " << material.model << ", error " << e.error;
            EXPECT_LT(e.error, 5e-3);
        }
}

/// A lamp behind a slab of glass, seen straight through it: light goes to and fro between the boundaries, T = (1 - R) / (1 + R). A thin
/// pane is the same.
TEST(Materials, LampBehindGlass) {
    const double r = fresnel_dielectric(1.0F, 1.5F).reflected, expected = (1 - r) / (1 + r);
    for (const bool thin : {false, true}) {
        Scene scene;
        add_quad(scene, "lamp", {-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, white_lamp);
        add_quad(scene, "near", {-1, -1, 0.1}, {2, 0, 0}, {0, 2, 0}, black);
        SceneMaterial glass = scene_material(MATERIAL_DIELECTRIC);
        glass.thin = thin;
        paint(scene, glass);
        if (!thin) {
            add_quad(scene, "far", {-1, -1, 0}, {0, 2, 0}, {2, 0, 0}, black);
            paint(scene, glass);
        }
        look_at(scene, {0, 0, 2}, dvec3(0), {0, 1, 0}, 0.5, 8, 8);
        expect_mean(trace(scene, 256), expected, 1e-2, thin ? "pane" : "slab");
    }
}

/// A metal mirror shows a lamp with the reflectance of its angle, and counts as one bounce.
TEST(Materials, LampInAMirror) {
    Scene scene;
    add_quad(scene, "mirror", {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, black);
    SceneMaterial metal = scene_material(MATERIAL_CONDUCTOR);
    metal.eta = glm::vec3(0.2F);
    metal.k = glm::vec3(3.9F);
    paint(scene, metal);
    add_quad(scene, "lamp", {-3, 2, -3}, {6, 0, 0}, {0, 0, 6}, white_lamp);
    look_at(scene, {0, 1, 1}, dvec3(0), {0, 1, 0}, 1.0, 8, 8);
    const Layer image = layer(trace(scene, 4, 2).layers, "");
    expect_uniform(image, fresnel_conductor(std::sqrt(0.5F), 0.2F, 3.9F), 2e-3);
    expect_zero(layer(trace(scene, 4, 1).layers, ""));
}

/// A sheet that lets 3/4 through, over a floor: light from a point, a lamp or from far away is dimmed alike, without a bounce.
TEST(Materials, MasksDimAllLightsAlike) {
    for (int kind = 0; kind < 3; ++kind) {
        Scene scene;
        add_quad(scene, "floor", {-3, 0, -3}, {0, 0, 6}, {6, 0, 0}, {glm::vec3(0.75F), glm::vec3(0.0F), false});
        if (kind == 0) scene.point_lights.push_back({{0, 2, 0}, glm::vec3(3.0F)});
        if (kind == 1) add_quad(scene, "lamp", {-0.5, 2, -0.5}, {1, 0, 0}, {0, 0, 1}, white_lamp);
        if (kind == 2) scene.environment.emplace();
        look_at(scene, {0.3, 0.1, 0.2}, {0.3, 0, 0.2}, {0, 0, 1}, 0.2, 8, 8);
        const Estimate open = mean_of_image(trace(scene, 1024, 2));
        scene.materials.push_back(scene_material(MATERIAL_PASS));
        add_quad(scene, "sheet", {-200, 1, -200}, {0, 0, 400}, {400, 0, 0}, black);
        SceneMaterial mask = scene_material(MATERIAL_BLEND);
        mask.blended[0] = static_cast<std::int64_t>(scene.materials.size()) - 2;
        mask.blended[1] = 0;  // the floor's material
        mask.weight = 0.25F;
        scene.materials.push_back(mask);
        for (Triangle3& t : scene.triangles)
            if (t.shape + 1 == scene.shapes.size()) t.material = static_cast<std::uint32_t>(scene.materials.size() - 1);
        const Estimate masked = mean_of_image(trace(scene, 1024, 2));
        EXPECT_NEAR(masked.mean, 0.75 * open.mean, 3 * masked.error + 3 * open.error + 1e-5) << kind;
        EXPECT_LT(masked.error, 0.01 * open.mean) << kind;
    }
}

/// A back of another material, and a back that has none.
TEST(Materials, BacksAreOtherMaterials) {
    for (int kind = 0; kind < 3; ++kind) {
        Scene scene;
        scene.environment.emplace();
        SceneMaterial other = scene_material(MATERIAL_DIFFUSE), front = other;
        other.albedo = glm::vec3(0.25F);
        scene.materials.push_back(other);
        add_quad(scene, "sheet", {-1, 0, -1}, {2, 0, 0}, {0, 0, 2}, black);  // its front looks down
        front.two_sided = kind > 0;
        if (kind == 2) front.back = 0;
        paint(scene, front);
        look_at(scene, {0, 1, 0}, dvec3(0), {0, 0, 1}, 10.0, 4, 4);
        const double expected[] = {0.0, 0.5, 0.25};
        const Estimate e = mean_of_image(trace(scene, 256, 2));
        EXPECT_NEAR(e.mean, expected[kind], 3 * e.error + 1e-6) << kind;
    }
}

/// Parallel light from above on a floor whose normal a texture turns: the cosine is that to the turned normal.
TEST(Materials, ReliefTurnsTheNormal) {
    const glm::vec3 n = glm::normalize(glm::vec3(0.3F, -0.2F, 1.0F));
    for (const bool bump : {false, true}) {
        Scene scene;
        add_quad(scene, "floor", {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {glm::vec3(0.5F), glm::vec3(0.0F), false});
        for (const dvec3& p : scene.positions) scene.uvs.push_back(0.5F * glm::vec2(p) + 0.5F);  // one unit is half a turn of the texture
        Texture texture;
        texture.width = texture.height = 4;
        texture.wrap_u = texture.wrap_v = Texture::Wrap::clamp;
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x) {
                // Heights rise against the normal: z = -(n.x x + n.y y) / n.z, and a texel is half a unit wide.
                const glm::vec3 value =
                    bump ? glm::vec3(2.0F - 0.5F * (n.x * static_cast<float>(x) + n.y * static_cast<float>(y)) / n.z) : 0.5F * n + 0.5F;
                texture.texels.push_back({glm::packHalf1x16(value.x), glm::packHalf1x16(value.y), glm::packHalf1x16(value.z), 0});
            }
        scene.textures.push_back(texture);
        scene.materials[0].normal_texture = 0;
        scene.materials[0].bump = bump;
        const dvec3 travel = glm::normalize(dvec3(-0.4, 0.1, -1));
        scene.directional_lights.push_back({travel, glm::vec3(2.0F)});
        look_at(scene, {0.1, 0.1, 1}, {0.1, 0.1, 0}, {0, 1, 0}, 0.2, 4, 4);
        expect_uniform(layer(trace(scene, 4).layers, ""), 0.5 / ref::pi * 2.0 * -glm::dot(dvec3(n), travel), 4e-3);
    }
}

/// The same where coordinates are mirrored: x is along u, y a left turn from it, or up in pictures whose v goes down.
TEST(Materials, ReliefOfMirroredCoordinates) {
    const glm::vec3 turned = glm::normalize(glm::vec3(0.3F, 0.2F, 1.0F));
    for (const bool y_against_v : {false, true})
        for (const float along_u : {1.0F, -1.0F}) {
            Scene scene;
            add_quad(scene, "floor", {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {glm::vec3(0.5F), glm::vec3(0.0F), false});
            for (const dvec3& p : scene.positions) scene.uvs.emplace_back(along_u * p.x, -p.y);
            Texture texture;
            texture.width = texture.height = 1;
            const glm::vec3 value = 0.5F * turned + 0.5F;
            texture.texels.push_back({glm::packHalf1x16(value.x), glm::packHalf1x16(value.y), glm::packHalf1x16(value.z), 0});
            scene.textures.push_back(texture);
            scene.materials[0].normal_texture = 0;
            scene.materials[0].y_against_v = y_against_v;
            const dvec3 n(along_u * turned.x, (y_against_v ? 1 : along_u) * turned.y, turned.z);
            const dvec3 travel = glm::normalize(dvec3(-0.4, -0.3, -1));
            scene.directional_lights.push_back({travel, glm::vec3(2.0F)});
            look_at(scene, {0.1, 0.1, 1}, {0.1, 0.1, 0}, {0, 1, 0}, 0.2, 4, 4);
            expect_uniform(layer(trace(scene, 4).layers, ""), 0.5 / ref::pi * 2.0 * -glm::dot(n, travel), 4e-3);
        }
}

}  // namespace
