// Materials and textures of glTF files.
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "unit/gltf_fixture.h"

namespace pencil::test {
namespace {

class GltfMaterials : public GltfTest {
protected:
    using Json = GltfBuilder::Json;

    Scene scene_of(const Json& material) const {
        GltfBuilder builder;
        builder.material(material);
        return load(builder);
    }
    static const SceneMaterial& used(const Scene& scene) { return scene.materials.at(scene.triangles.at(0).material); }
    static glm::vec4 texel(const Scene& scene, int texture, std::size_t i) {
        return glm::unpackHalf(scene.textures.at(static_cast<std::size_t>(texture)).texels.at(i));
    }
};

TEST_F(GltfMaterials, MetallicRoughness) {
    const Scene scene =
        scene_of({{"name", "brass"},
                  {"pbrMetallicRoughness", {{"baseColorFactor", {0.8, 0.6, 0.4, 1}}, {"metallicFactor", 0.25}, {"roughnessFactor", 0.3}}}});
    const SceneMaterial& m = used(scene);
    EXPECT_EQ(m.id, "brass");
    EXPECT_EQ(m.model, MATERIAL_PRINCIPLED);
    EXPECT_TRUE(m.two_sided);
    EXPECT_EQ(m.albedo, glm::vec3(0.8F, 0.6F, 0.4F));
    EXPECT_EQ(m.alpha, glm::vec2(0.3F));
    EXPECT_EQ(m.principled.metallic, 0.25F);
    EXPECT_NEAR(m.eta.x, 1.5F, 1e-6);
    EXPECT_EQ(m.albedo_texture, no_texture);
}

TEST_F(GltfMaterials, WithoutMaterialItIsTheDefaultOfGltf) {
    GltfBuilder builder;
    builder.triangle();
    const Scene scene = load(builder);
    EXPECT_EQ(used(scene).albedo, glm::vec3(1));
    EXPECT_EQ(used(scene).principled.metallic, 1.0F);
    EXPECT_EQ(used(scene).alpha, glm::vec2(1));
}

TEST_F(GltfMaterials, TexturesOfOneChannel) {
    GltfBuilder builder;
    const int picture = texture(builder, png(2, 1, 3, {10, 51, 255, 20, 102, 0}));
    builder.material({{"pbrMetallicRoughness", {{"metallicRoughnessTexture", {{"index", picture}}}}}});
    const Scene scene = load(builder);
    const SceneMaterial& m = used(scene);
    EXPECT_NEAR(texel(scene, m.alpha_texture, 0).x, 0.2F, 1e-3);  // green, as stored
    EXPECT_NEAR(texel(scene, m.alpha_texture, 1).x, 0.4F, 1e-3);
    EXPECT_EQ(texel(scene, m.principled.metallic_texture, 0).x, 1.0F);  // blue
    EXPECT_EQ(texel(scene, m.principled.metallic_texture, 1).x, 0.0F);
}

TEST_F(GltfMaterials, SamplersAndTransforms) {
    GltfBuilder builder;
    const int picture = texture(builder, png(1, 1, 3, {255, 0, 0}));
    builder.add("samplers", {{"magFilter", 9728}, {"wrapS", 33071}, {"wrapT", 33648}});
    builder.json["textures"][0]["sampler"] = 0;
    // The lower left quarter of the picture, turned by a right angle: the example of the extension's specification.
    const Json transform = {{"offset", {0, 1}}, {"rotation", std::acos(-1.0) / 2}, {"scale", {0.5, 0.5}}};
    builder.material(
        {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", picture}, {"extensions", {{"KHR_texture_transform", transform}}}}}}}});
    const Scene scene = load(builder);
    const Texture& t = scene.textures.at(static_cast<std::size_t>(used(scene).albedo_texture));
    EXPECT_TRUE(t.nearest);
    EXPECT_EQ(t.wrap_u, Texture::Wrap::clamp);
    EXPECT_EQ(t.wrap_v, Texture::Wrap::mirror);
    expect_near(t.to_uv * glm::dvec3(0, 0, 1), {0, 1, 1}, 1e-12);
    expect_near(t.to_uv * glm::dvec3(1, 0, 1), {0, 0.5, 1}, 1e-12);
    expect_near(t.to_uv * glm::dvec3(0, 1, 1), {0.5, 1, 1}, 1e-12);
}

TEST_F(GltfMaterials, NormalMapsAreScaled) {
    GltfBuilder builder;
    const int picture = texture(builder, png(1, 1, 3, {255, 128, 128}));
    builder.material({{"normalTexture", {{"index", picture}, {"scale", 0.0}}}});
    const Scene scene = load(builder);
    const glm::vec4 n = texel(scene, used(scene).normal_texture, 0);
    EXPECT_NEAR(n.x, 0.5F, 1e-3);
    EXPECT_NEAR(n.z, 1.0F, 1e-3);
    EXPECT_FALSE(used(scene).bump);
    EXPECT_TRUE(used(scene).y_against_v);
}

TEST_F(GltfMaterials, BlendedOverWhatLetsLightPass) {
    const Scene scene = scene_of({{"alphaMode", "BLEND"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.25}}}}});
    const SceneMaterial& m = used(scene);
    ASSERT_EQ(m.model, MATERIAL_BLEND);
    EXPECT_EQ(m.weight, 0.25F);
    EXPECT_EQ(m.weight_texture, no_texture);
    EXPECT_EQ(scene.materials.at(static_cast<std::size_t>(m.blended[0])).model, MATERIAL_PASS);
    EXPECT_EQ(scene.materials.at(static_cast<std::size_t>(m.blended[1])).model, MATERIAL_PRINCIPLED);
    EXPECT_EQ(used(scene_of({{"alphaMode", "BLEND"}})).model, MATERIAL_PRINCIPLED);
}

TEST_F(GltfMaterials, MasksAreCut) {
    GltfBuilder builder;
    const int picture = texture(builder, png(2, 1, 4, {255, 255, 255, 100, 255, 255, 255, 200}));
    const Json pbr = {{"baseColorTexture", {{"index", picture}}}, {"baseColorFactor", {1, 1, 1, 0.9}}};
    builder.material({{"alphaMode", "MASK"}, {"alphaCutoff", 0.6}, {"pbrMetallicRoughness", pbr}});
    const Scene scene = load(builder);
    const SceneMaterial& m = used(scene);
    ASSERT_EQ(m.model, MATERIAL_BLEND);
    EXPECT_TRUE(m.weight_is_opacity);
    EXPECT_EQ(m.weight, 1.0F);
    EXPECT_EQ(texel(scene, m.weight_texture, 0).w, 0.0F);
    EXPECT_EQ(texel(scene, m.weight_texture, 1).w, 1.0F);
    EXPECT_EQ(used(scene_of({{"alphaMode", "MASK"}})).model, MATERIAL_PRINCIPLED);
    EXPECT_EQ(used(scene_of({{"alphaMode", "MASK"}, {"alphaCutoff", 2}})).weight, 0.0F);
}

TEST_F(GltfMaterials, PicturesWithoutOpacityNeedNoBlend) {
    GltfBuilder builder;
    const int picture = texture(builder, png(1, 1, 3, {9, 9, 9}));
    builder.material({{"alphaMode", "BLEND"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", picture}}}}}});
    EXPECT_EQ(used(load(builder)).model, MATERIAL_PRINCIPLED);
}

TEST_F(GltfMaterials, Emission) {
    GltfBuilder builder;
    const int picture = texture(builder, png(1, 1, 3, {255, 255, 255}));
    builder.material({{"emissiveFactor", {1, 0.5, 0.25}},
                      {"emissiveTexture", {{"index", picture}}},
                      {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}}}}});
    const Scene scene = load(builder);
    EXPECT_TRUE(scene.shapes[0].emits);
    EXPECT_EQ(scene.shapes[0].radiance, glm::vec3(8, 4, 2));
    EXPECT_NE(scene.shapes[0].radiance_texture, no_texture);
    EXPECT_FALSE(scene.environment);
}

/// The older model: what is no metal keeps its diffuse colour, what reflects much and has no diffuse colour is a metal.
TEST_F(GltfMaterials, SpecularAndGlossiness) {
    const auto of = [&](const Json& content) { return scene_of({{"extensions", {{"KHR_materials_pbrSpecularGlossiness", content}}}}); };
    const Scene plain = of({{"diffuseFactor", {0.8, 0.4, 0.2, 1}}, {"specularFactor", {0.04, 0.04, 0.04}}, {"glossinessFactor", 0.25}});
    EXPECT_EQ(used(plain).model, MATERIAL_PRINCIPLED);
    EXPECT_EQ(used(plain).principled.metallic, 0);
    EXPECT_NEAR(used(plain).albedo.x, 0.8, 1e-3);
    EXPECT_NEAR(used(plain).albedo.z, 0.2, 1e-3);
    EXPECT_FLOAT_EQ(used(plain).alpha.x, 0.75F);
    EXPECT_TRUE(plain.warnings.size() == 2) << "no camera, no light";
    const Scene gold = of({{"diffuseFactor", {0, 0, 0, 1}}, {"specularFactor", {1, 0.8, 0.3}}});
    EXPECT_NEAR(used(gold).principled.metallic, 1, 1e-3);
    EXPECT_NEAR(used(gold).albedo.y, 0.8, 1e-3);
    EXPECT_EQ(used(gold).alpha.x, 0);
    EXPECT_NE(used(of({{"diffuseFactor", {1, 1, 1, 0.5}}})).model, MATERIAL_BLEND) << "opaque unless the material says BLEND";
}

TEST_F(GltfMaterials, SpecularAndGlossinessByPictures) {
    GltfBuilder builder;
    const int diffuse = texture(builder, png(2, 1, 4, {255, 0, 0, 255, 0, 0, 0, 255}));
    const int specular = texture(builder, png(2, 1, 4, {0, 0, 0, 255, 255, 255, 255, 0}));
    builder.material({{"extensions",
                       {{"KHR_materials_pbrSpecularGlossiness",
                         {{"diffuseTexture", {{"index", diffuse}}}, {"specularGlossinessTexture", {{"index", specular}}}}}}}});
    const Scene scene = load(builder);
    const SceneMaterial& material = used(scene);
    EXPECT_NEAR(texel(scene, material.albedo_texture, 0).x, 1, 0.01);
    EXPECT_NEAR(texel(scene, material.albedo_texture, 0).y, 0, 0.01);
    EXPECT_NEAR(texel(scene, material.albedo_texture, 1).y, 1, 0.01);
    EXPECT_EQ(material.principled.metallic, 1);
    EXPECT_EQ(texel(scene, material.principled.metallic_texture, 0).x, 0);
    EXPECT_NEAR(texel(scene, material.principled.metallic_texture, 1).x, 1, 0.01);
    EXPECT_EQ(texel(scene, material.alpha_texture, 0).x, 0);
    EXPECT_EQ(texel(scene, material.alpha_texture, 1).x, 1);
}

TEST_F(GltfMaterials, ThinAndSolidGlass) {
    const Json clear = {{"transmissionFactor", 1}},
               pbr = {{"metallicFactor", 0}, {"roughnessFactor", 0}, {"baseColorFactor", {0.5, 1, 1, 1}}};
    const Scene thin = scene_of({{"pbrMetallicRoughness", pbr}, {"extensions", {{"KHR_materials_transmission", clear}}}});
    EXPECT_EQ(used(thin).model, MATERIAL_DIELECTRIC);
    EXPECT_TRUE(used(thin).thin);
    EXPECT_EQ(used(thin).transmitted, glm::vec3(0.5F, 1, 1));
    const Scene solid = scene_of({{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0.5}}},
                                  {"extensions",
                                   {{"KHR_materials_transmission", clear},
                                    {"KHR_materials_ior", {{"ior", 1.33}}},
                                    {"KHR_materials_volume", {{"thicknessFactor", 1}, {"attenuationDistance", 2}}}}}});
    EXPECT_FALSE(used(solid).thin);
    EXPECT_NEAR(used(solid).eta.x, 1.33F, 1e-6);
    EXPECT_EQ(used(solid).alpha, glm::vec2(0.25F));
    EXPECT_TRUE(has_warning(solid, "absorption"));
    const Scene half =
        scene_of({{"pbrMetallicRoughness", pbr}, {"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 0.5}}}}}});
    ASSERT_EQ(used(half).model, MATERIAL_BLEND);
    EXPECT_EQ(used(half).weight, 0.5F);
    EXPECT_EQ(half.materials.at(static_cast<std::size_t>(used(half).blended[1])).model, MATERIAL_DIELECTRIC);
}

TEST_F(GltfMaterials, Coats) {
    const Scene scene = scene_of({{"extensions",
                                   {{"KHR_materials_clearcoat", {{"clearcoatFactor", 0.5}, {"clearcoatRoughnessFactor", 0.25}}},
                                    {"KHR_materials_sheen", {{"sheenColorFactor", {0.5, 0.5, 0.5}}}},
                                    {"KHR_materials_specular", {{"specularFactor", 0}}}}}});
    const SceneMaterial& m = used(scene);
    EXPECT_EQ(m.principled.clearcoat, 0.5F);
    EXPECT_EQ(m.principled.clearcoat_gloss, 0.75F);
    EXPECT_EQ(m.principled.sheen, 0.5F);
    EXPECT_EQ(m.principled.sheen_tint, 0.0F);
    EXPECT_NEAR(m.eta.x, 1.001F, 1e-6);
}

TEST_F(GltfMaterials, UnlitIsDiffuse) {
    const Scene scene = scene_of({{"extensions", {{"KHR_materials_unlit", Json::object()}}}});
    EXPECT_EQ(used(scene).model, MATERIAL_DIFFUSE);
    EXPECT_TRUE(has_warning(scene, "unlit"));
}

TEST_F(GltfMaterials, TheSecondSetOfTextureCoordinates) {
    GltfBuilder builder;
    const int picture = texture(builder, png(1, 1, 3, {9, 9, 9}));
    builder.material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", picture}, {"texCoord", 1}}}}},
                      {"emissiveTexture", {{"index", picture}}},
                      {"emissiveFactor", {1, 1, 1}}});
    builder.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] = builder.floats({9, 9, 8, 8, 7, 7}, "VEC2");
    const Scene scene = load(builder);
    EXPECT_EQ(scene.uvs[0], glm::vec2(9, 9));
    EXPECT_TRUE(has_warning(scene, "another set of texture coordinates"));
}

}  // namespace
}  // namespace pencil::test
