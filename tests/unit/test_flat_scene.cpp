// Rows of materials in the flattened scene: who shares one and who has one alone.
#include <gtest/gtest.h>

#include <cmath>

#include "pencils/light_samples.h"
#include "scenes/scene_parts.h"

namespace {

using namespace pencil;
using namespace pencil::test;

const Surface grey{glm::vec3(0.5F), glm::vec3(0.0F), false};

Surface lamp(float radiance) { return {glm::vec3(0.2F), glm::vec3(radiance), true}; }

/// Unit square in the plane z = `height`.
void add_square(Scene& scene, const std::string& id, double height, const Surface& surface, double size = 1) {
    add_quad(scene, id, {0, 0, height}, {size, 0, 0}, {0, size, 0}, surface);
}

FlatScene flat_of(const Scene& scene, LightForm form = LightForm::samples) {
    return flatten(scene, std::vector<LightForm>(scene.shapes.size(), form), 4, 4);
}

int row(const FlatScene& flat, std::size_t triangle) { return flat.triangles.at(triangle).material; }

TEST(FlatScene, ShapesOfOneMaterialShareItsRow) {
    Scene scene;
    for (int i = 0; i < 3; ++i) add_square(scene, "wall", i, grey);
    scene.triangles[2].material = scene.triangles[3].material = 0;  // the second wall has the first one's
    const FlatScene flat = flat_of(scene);
    EXPECT_EQ(flat.shape_count, 3);
    ASSERT_EQ(flat.materials.size(), 2U);  // the second material is not in use
    EXPECT_EQ(row(flat, 2), row(flat, 0));
    EXPECT_NE(row(flat, 4), row(flat, 0));
    EXPECT_EQ(flat.triangles[2].shape, 1);
    EXPECT_EQ(flat.materials[0].albedo, float4(0.5F, 0.5F, 0.5F, 0.0F));
    EXPECT_EQ(flat.materials[0].emission, float4(0.0F));
}

TEST(FlatScene, EveryEmittingShapeHasARowOfItsOwn) {
    Scene scene;
    add_square(scene, "lamp 1", 0, lamp(1));
    add_square(scene, "lamp 2", 1, lamp(2));
    add_square(scene, "shade", 2, lamp(0));
    for (Triangle3& t : scene.triangles) t.material = 0;
    for (const LightForm form : {LightForm::samples, LightForm::maps}) {
        const FlatScene flat = flat_of(scene, form);
        ASSERT_EQ(flat.materials.size(), 3U);
        for (std::size_t i = 0; i < 3; ++i) {
            const Material& m = flat.materials[static_cast<std::size_t>(row(flat, 2 * i))];
            EXPECT_EQ(m.albedo, float4(0.2F, 0.2F, 0.2F, 1.0F));
            EXPECT_EQ(m.emission.x, i < 2 ? static_cast<float>(i + 1) : 0.0F);
            EXPECT_EQ(m.emission.w, form == LightForm::maps && i < 2 ? 1.0F : 0.0F);
            EXPECT_EQ(row(flat, 2 * i), row(flat, 2 * i + 1));
        }
    }
}

TEST(FlatScene, APlaneIsOfOneShapeAndMaterial) {
    Scene scene;
    add_square(scene, "floor", 0, grey);
    EXPECT_EQ(flat_of(scene).planes.size(), 1U);
    scene.materials.push_back(scene.materials[0]);
    scene.triangles[1].material = 1;
    const FlatScene flat = flat_of(scene);
    ASSERT_EQ(flat.planes.size(), 2U);
    EXPECT_EQ(flat.planes[0], flat.planes[1]);
    EXPECT_EQ(flat.triangles[0].mates, 0);
    EXPECT_EQ(flat.triangles[0].shape, flat.triangles[1].shape);
}

TEST(FlatScene, AWallWithADoorKnowsAllItsTriangles) {
    Scene scene;
    add_square(scene, "wall", 0, grey);
    for (int k = 0; k < 5; ++k) {
        const Triangle3 first = scene.triangles[0], second = scene.triangles[1];
        scene.triangles.push_back(first);
        scene.triangles.push_back(second);
    }
    const FlatScene flat = flat_of(scene);
    ASSERT_EQ(flat.planes.size(), 1U);
    for (int i = 0; i < 12; ++i) {
        EXPECT_EQ(MATES_BEFORE(flat.triangles[static_cast<std::size_t>(i)].mates), i);
        EXPECT_EQ(MATES_AFTER(flat.triangles[static_cast<std::size_t>(i)].mates), 11 - i);
    }
}

TEST(FlatScene, NearAreasAreOfTheEmittingShape) {
    Scene scene;
    add_square(scene, "wall", 0, grey);
    add_square(scene, "large lamp", 1, lamp(1), 4);
    add_square(scene, "small lamp", 2, lamp(1));
    for (std::size_t t = 2; t < 6; ++t) scene.triangles[t].material = 1;  // both lamps are of one material,
    scene.triangles[5].material = 0;                                      // but one half of the small one is of the wall's
    const FlatScene flat = flat_of(scene);
    ASSERT_EQ(flat.materials.size(), 4U);
    const std::vector<LightForm> forms(3, LightForm::samples);
    const std::vector<float> areas = near_areas(flat, sample_lights(scene, flat, forms, 34, 1));  // 29 and 5, mostly by power
    const auto near = [&](std::size_t triangle) { return areas.at(static_cast<std::size_t>(row(flat, triangle))); };
    const double unit = flat.normalisation.scale * flat.normalisation.scale * M_PI;
    EXPECT_TRUE(std::isinf(near(0)));
    EXPECT_NEAR(near(2) * unit, 16.0 / 29, 1e-6);
    EXPECT_NEAR(near(4) * unit, 1.0 / 5, 1e-6);
    EXPECT_EQ(near(4), near(5));
}

}  // namespace
