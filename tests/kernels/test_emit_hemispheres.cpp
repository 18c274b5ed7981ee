// Emission that pencils see near emitters; with what light samples carry it is all of the emitter's light.
#include "film/light_surfels.h"
#include "kernels/surface_test.h"
#include "reference/form_factor_ref.h"
#include "reference/hemisphere_ref.h"
#include "reference/tolerances.h"
#include "surface/emit_hemispheres.h"
#include "surface/sum_hemispheres.h"
#include "surface/trace_hemispheres.h"

namespace {

using namespace pencil;
using namespace pencil::test;

constexpr float start = 0.25F;  // what the surfels send before

/// Emitters with and without light samples, and materials that do not emit.
TestScene emitters(Random& random) {
    TestScene scene = box_scene(3);
    for (std::size_t m = 0; m < scene.flat.materials.size(); ++m)
        if (m % 3 == 0) scene.flat.materials[m].emission = float4(0);
    scene.flat.materials[1].emission = float4(static_cast<float>(random.uniform(1, 5)), 0, 0, 1);
    return scene;
}

TEST(EmitHemispheres, IsTheShareThatLightSamplesLeave) {
    Random random(31);
    const TestScene scene = emitters(random);
    const DeviceScene on_scene(device(), scene.flat);
    const int materials = static_cast<int>(scene.flat.materials.size());
    std::vector<float> near_area;
    for (int m = 0; m < materials; ++m)
        near_area.push_back(m % 4 == 1 ? HUGE_VALF : static_cast<float>(std::pow(10.0, random.uniform(-5, 0))));
    Kernels kernels = make_kernels();
    for (const int n : {4, 8})
        for (const int count : {1, 5, 37}) {
            const int first = count % 4, texels = n * n;
            const std::vector<SurfacePencil> pencils = random_pencils(7, first + count);
            const MadeSurfels surfels = seen_materials(random, count * texels, materials);
            Buffer<float> radiance = filled_rgb(surfels.capacity, start);
            emit_hemispheres(kernels, on_scene, surfels.on_device(), {on_device(pencils, n), first},
                             Buffer<float>(device(), near_area, "near areas"), radiance);
            const std::vector<float> got = radiance.read();
            for (int i = 0; i < surfels.capacity; ++i) {
                const int m = surfels.bits(SURFEL_MATERIAL, i);
                dvec3 expected(start);
                if (i < surfels.count && m >= 0 && m != PENCIL_NO_MATERIAL) {
                    const auto at = static_cast<std::size_t>(m);
                    const double r =
                        glm::distance(surfels.position(i), xyz(pencils[static_cast<std::size_t>(first + i / texels)].position));
                    expected += xyz(scene.flat.materials[at].emission) * ref::seen_share(r, near_area[at]);
                }
                expect_close(rgb_at(got, static_cast<std::size_t>(surfels.capacity), i), expected, tolerance::accumulation,
                             "surfel " + std::to_string(i) + " of material " + std::to_string(m));
            }
        }
}

/// The floor of the unit box whose wall x = 0 shines: irradiance per unit radiance from light samples plus that from texels, as near to the
/// wall as one likes and whatever area the samples stand for.
TEST(EmitHemispheres, WithLightSamplesIsTheWholeLitWall) {
    // The wall alone: nothing hides it.
    TestScene scene = make_scene({{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, 0}, {{0, 0, 0}, {0, 1, 1}, {0, 0, 1}, 0}}, 1, 1);
    scene.flat.materials[0].emission = float4(1, 1, 1, 0);
    const DeviceScene on_scene(device(), scene.flat, build_bvh(scene.flat.triangles));
    Features features;
    features.bvh = true;
    Kernels kernels(device(), features);
    const std::vector<dvec3> points{{0.02, 0, 0.5}, {0.1, 0, 0.2}, {0.5, 0, 0.5}, {0.9, 0, 0.9}};
    const int n = 64, count = static_cast<int>(points.size());
    MadeSurfels floor(count);
    std::vector<SurfacePencil> pencils = random_pencils(1, count);
    for (int i = 0; i < count; ++i) {
        floor.place(i, points[static_cast<std::size_t>(i)], {0, 1, 0}, -1, dvec3(1));
        floor.set_bits(SURFEL_PLANE, i, 77);
        pencils[static_cast<std::size_t>(i)].position = to_float4(points[static_cast<std::size_t>(i)]);
        pencils[static_cast<std::size_t>(i)].normal = pencils[static_cast<std::size_t>(i)].facing = float4(0, 1, 0, 0);
    }
    constexpr int across = 128;  // light samples, stratified
    for (const double area_over_pi : {1e-3, 0.05}) {
        Random random(5);
        std::vector<LightSample> samples;
        for (int k = 0; k < across * across; ++k) {
            LightSample s{};
            s.position = to_float4({0, (k / across + random.uniform()) / across, (k % across + random.uniform()) / across}, 1.0);
            s.normal = to_float4({1, 0, 0}, area_over_pi);
            s.emission = to_float4(dvec3(1.0 / (across * across)), 0.0);
            samples.push_back(s);
        }
        const LightSet lights(device(), samples, 0);
        Buffer<float> sampled = filled_rgb(floor.capacity, 0);
        light_surfels(kernels, on_scene, floor.on_device(), lights, sampled, "test");
        const SurfacePencils set = on_device(pencils, n);
        Surfels seen(device(), count * n * n, "seen");
        trace_hemispheres(kernels, on_scene, set, 0, count, {3}, seen);
        Buffer<float> radiance = filled_rgb(seen.capacity, 0);
        emit_hemispheres(kernels, on_scene, seen, {set, 0},
                         Buffer<float>(device(), std::vector<float>{static_cast<float>(area_over_pi)}, "near area"), radiance);
        Buffer<float4> near(device(), static_cast<std::size_t>(count), "irradiance");
        sum_hemispheres(kernels, radiance, seen.capacity, 0, 0, count, n, near);
        const std::vector<float> far = sampled.read();
        const std::vector<float4> seen_light = near.read();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double both = static_cast<double>(far[i]) * ref::pi + static_cast<double>(seen_light[i].x);
            EXPECT_NEAR(both / ref::lit_wall_irradiance(points[i].x, points[i].z), 1.0, tolerance::strata)
                << "at x = " << points[i].x << ", A/pi = " << area_over_pi << ": samples " << static_cast<double>(far[i]) * ref::pi
                << ", texels " << seen_light[i].x;
        }
    }
}

}  // namespace
