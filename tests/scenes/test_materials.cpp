// Materials with lobes: the surface method against the path tracer.
#include <glm/gtc/packing.hpp>

#include "scenes/against_paths.h"

namespace {

using namespace pencil;
using namespace pencil::test;

SceneMaterial with_model(int model, float alpha) {
    SceneMaterial m;
    m.model = model;
    m.alpha = glm::vec2(alpha);
    m.albedo = glm::vec3(0.7F, 0.4F, 0.3F);
    return m;
}

/// A room with coloured walls, a lamp under its ceiling, and a thing of the material in its middle.
Scene room_with(const SceneMaterial& material) {
    Scene scene;
    add_box(scene, dvec3(0.0), dvec3(1.0), Surface{glm::vec3(0.6F)});
    scene.materials[0].albedo = glm::vec3(0.6F, 0.2F, 0.2F);
    scene.materials[1].albedo = glm::vec3(0.2F, 0.3F, 0.6F);
    add_quad(scene, "lamp", {0.3, 0.98, 0.3}, {0.4, 0, 0}, {0, 0, 0.4}, Surface{glm::vec3(0.0F), glm::vec3(8.0F)});
    add_box(scene, {0.3, 0.1, 0.35}, {0.7, 0.5, 0.75}, Surface{glm::vec3(0.5F)}, false);
    for (std::size_t m = 7; m < scene.materials.size(); ++m) {
        const bool two_sided = scene.materials[m].two_sided;
        scene.materials[m] = material;
        scene.materials[m].two_sided = two_sided;
    }
    look_at(scene, {0.15, 0.75, 0.02}, {0.55, 0.3, 0.6}, {0, 1, 0}, 60.0, compared_size, compared_size);
    return scene;
}

struct Case {
    const char* name;
    SceneMaterial material;
    double bound = 0.01;
    double target_error = 2e-3;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

SceneMaterial metal(float alpha) {
    SceneMaterial m = with_model(MATERIAL_CONDUCTOR, alpha);
    m.eta = glm::vec3(0.2F, 0.9F, 1.4F);
    m.k = glm::vec3(3.9F, 2.4F, 1.6F);
    return m;
}

SceneMaterial thin_glass() {
    SceneMaterial m = with_model(MATERIAL_DIELECTRIC, 0.0F);
    m.thin = true;
    return m;
}

SceneMaterial phong() {
    SceneMaterial m = with_model(MATERIAL_PHONG, 0.0F);
    m.albedo = glm::vec3(0.4F, 0.3F, 0.1F);
    m.specular = glm::vec3(0.3F, 0.4F, 0.5F);
    return m;
}

SceneMaterial principled(float metallic, float spec_trans, float clearcoat) {
    SceneMaterial m = with_model(MATERIAL_PRINCIPLED, 0.4F);
    m.principled.metallic = metallic;
    m.principled.spec_trans = spec_trans;
    m.principled.clearcoat = clearcoat;
    return m;
}

const std::vector<Case> cases{{"Mirror", metal(0.0F)},
                              {"RoughMetal", metal(0.3F)},
                              {"Plastic", with_model(MATERIAL_PLASTIC, 0.0F)},
                              {"RoughPlastic", with_model(MATERIAL_PLASTIC, 0.2F)},
                              {"Glass", with_model(MATERIAL_DIELECTRIC, 0.0F)},
                              {"RoughGlass", with_model(MATERIAL_DIELECTRIC, 0.2F), 0.01, 5e-4},  // noise of the first passes
                              {"ThinGlass", thin_glass(), 0.02},  // what is seen through panes is noise: seeds differ by half a percent
                              {"Phong", phong()},
                              {"RoughDiffuse", with_model(MATERIAL_ROUGH_DIFFUSE, 0.5F)},
                              {"Principled", principled(0.3F, 0.0F, 1.0F)},
                              {"PrincipledGlass", principled(0.0F, 1.0F, 0.0F)}};

class MaterialModels : public testing::TestWithParam<Case> {};
TEST_P(MaterialModels, AreThePathTracers) {
    expect_path_tracers(room_with(GetParam().material), GetParam().bound, 1024, GetParam().target_error);
}

/// Stripes of some heights or colours.
Texture stripes() {
    Texture texture;
    texture.width = 8;
    texture.height = 4;
    for (int i = 0; i < 32; ++i) {
        const float value = i % 8 < 3 ? 0.1F : 0.9F;
        texture.texels.push_back(glm::packHalf(glm::vec4(value, 0.5F * value, 1.0F - value, 1.0F)));
    }
    return texture;
}

/// Texture coordinates of all of the scene: x and z of the world, y on what stands.
void unwrap(Scene& scene) {
    for (const dvec3& p : scene.positions) scene.uvs.emplace_back(p.x + 0.5 * p.y, p.z + 0.5 * p.y);
}

TEST(Materials, TexturedEmittersOnReliefAreThePathTracers) {
    SceneMaterial bumpy = with_model(MATERIAL_DIFFUSE, 0.0F);
    bumpy.normal_texture = 0;
    bumpy.bump = true;
    bumpy.bump_scale = 0.05F;
    Scene scene = room_with(bumpy);
    scene.textures.push_back(stripes());
    unwrap(scene);
    for (Shape& shape : scene.shapes)
        if (shape.emits) shape.radiance_texture = 0;
    expect_path_tracers(scene, 0.01, 1024, 2e-4);  // stripes of colour are the noise of the first passes
}

/// What emits reflects, too: also along its lobes.
TEST(Materials, LampsOfMetalShowTheRoom) {
    Scene scene = room_with(metal(0.2F));
    for (const Triangle3& t : scene.triangles) {
        if (t.material < 7) continue;
        scene.shapes[t.shape].emits = true;
        scene.shapes[t.shape].radiance = glm::vec3(0.2F, 0.1F, 0.05F);
    }
    expect_path_tracers(scene, 0.01);
}

/// Colours of vertices, of light samples as well as of what rays meet.
TEST(Materials, LampsWithColoursOfVertices) {
    Scene scene = room_with(with_model(MATERIAL_DIFFUSE, 0.0F));
    Texture colours;
    colours.kind = Texture::Kind::vertex_colours;
    scene.textures.push_back(colours);
    for (std::size_t i = 0; i < scene.positions.size(); ++i)
        scene.colours.emplace_back(i % 2 == 0 ? 1.8F : 0.1F, i % 3 == 0 ? 1.5F : 0.2F, 1.0F);
    for (Shape& shape : scene.shapes)
        if (shape.emits) shape.radiance_texture = 0;
    expect_path_tracers(scene, 0.01);
}

/// The floor behind the plane of an emitter that stands on it is black, however little of the scene says so: nothing but the emitter is near.
TEST(Materials, NoLightBehindAnEmitter) {
    Scene scene;
    add_quad(scene, "floor", {-2, 0, -2}, {0, 0, 4}, {4, 0, 0}, Surface{glm::vec3(0.6F)});
    add_quad(scene, "lamp", {-0.5, 0.1, 0}, {1, 0, 0}, {0, 1, 0}, Surface{glm::vec3(0.0F), glm::vec3(1.0F)});
    look_at(scene, {0, 4, 0.001}, {0, 0, 0}, {0, 0, -1}, 50.0, compared_size, compared_size);
    const RenderResult result = render_layers(scene, compared_options());
    const Layer& image = layer(result, "");
    double lit = 0, dark = 0;
    for (std::size_t row = 0; row < compared_size; ++row)
        for (std::size_t column = 0; column < compared_size; ++column) {
            const double value = pixel(image, row * compared_size + column).y;
            (row < compared_size / 2 - 1 ? dark : lit) += value;
        }
    EXPECT_GT(lit, 1.0);
    EXPECT_LT(dark, 1e-3 * lit);
}

INSTANTIATE_TEST_SUITE_P(Of, MaterialModels, testing::ValuesIn(cases), [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
