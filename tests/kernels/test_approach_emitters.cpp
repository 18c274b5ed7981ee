// How near the emitters are that pencils see, as far as pencils carry their light.
#include "kernels/surface_test.h"
#include "reference/hemisphere_ref.h"
#include "reference/tolerances.h"
#include "surface/approach_emitters.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// The scene's box has materials that emit: every third does not.
TestScene emitters() {
    TestScene scene = box_scene(3);
    for (std::size_t m = 0; m < scene.flat.materials.size(); ++m)
        scene.flat.materials[m].emission = m % 3 == 0 ? float4(0) : float4(0, 2, 0, 0);
    return scene;
}

std::vector<float> approached(const TestScene& scene, const MadeSurfels& surfels, const std::vector<float>& near_area, int n,
                              std::vector<SurfacePencil>& pencils, int first) {
    Kernels kernels = make_kernels();
    const DeviceScene on_scene(device(), scene.flat);
    SurfacePencils set = on_device(pencils, n);
    approach_emitters(kernels, on_scene, surfels.on_device(), first, set.count - first, Buffer<float>(device(), near_area, "near areas"),
                      set);
    std::vector<float> distances;
    for (const SurfacePencil& p : set.data.read(0, pencils.size())) distances.push_back(p.emitters);
    return distances;
}

TEST(ApproachEmitters, IsTheMeanByTheShareThatPencilsCarry) {
    Random random(41);
    const TestScene scene = emitters();
    const int materials = static_cast<int>(scene.flat.materials.size());
    std::vector<float> near_area;
    for (int m = 0; m < materials; ++m)
        near_area.push_back(m % 4 == 1 ? HUGE_VALF : static_cast<float>(std::pow(10.0, random.uniform(-5, 0))));
    for (const int n : {4, 8})
        for (const int count : {1, 5, 37}) {
            const int first = count % 4, texels = n * n;
            std::vector<SurfacePencil> pencils = random_pencils(8, first + count);
            const MadeSurfels surfels = seen_materials(random, count * texels, materials);
            const std::vector<float> got = approached(scene, surfels, near_area, n, pencils, first);
            for (int p = 0; p < count; ++p) {
                const auto index = static_cast<std::size_t>(first + p);
                double shares = 0, inverse = 0, most = 0;
                for (int i = p * texels; i < (p + 1) * texels; ++i) {
                    const int m = surfels.bits(SURFEL_MATERIAL, i);
                    if (m < 0 || m == PENCIL_NO_MATERIAL || m % 3 == 0) continue;
                    const double r = glm::distance(surfels.position(i), xyz(pencils[index].position));
                    const double share = ref::seen_share(r, near_area[static_cast<std::size_t>(m)]);
                    shares += share;
                    inverse += share / r;
                    most = std::max(most, share);
                }
                if (inverse == 0)
                    EXPECT_EQ(got[index], HUGE_VALF);
                else
                    EXPECT_NEAR(got[index] / (shares / inverse / most), 1.0, tolerance::accumulation) << "pencil " << p;
            }
        }
}

/// An emitter that pencils carry all of is as far as it is; one that light samples carry hardly counts.
TEST(ApproachEmitters, WhatLightSamplesCarryIsFar) {
    const TestScene scene = emitters();
    std::vector<SurfacePencil> pencils = random_pencils(9, 1);
    MadeSurfels surfels(16);
    for (int i = 0; i < 16; ++i) {
        surfels.place(i, xyz(pencils[0].position) + dvec3(0.5, 0, 0), dvec3(-1, 0, 0), 0, dvec3(0));
        surfels.set_bits(SURFEL_MATERIAL, i, 1);
    }
    std::vector<float> near_area(scene.flat.materials.size(), HUGE_VALF);
    EXPECT_NEAR(approached(scene, surfels, near_area, 4, pencils, 0)[0], 0.5, 1e-5);
    near_area[1] = 1e-4F;
    EXPECT_GT(approached(scene, surfels, near_area, 4, pencils, 0)[0], 1000.0F);
}

}  // namespace
