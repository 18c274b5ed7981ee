// Direct light against thesis alg. 6.2: in an empty box against the whole truth, among occluders with the visibility that the maps give.
#include "film/light_surfels.h"
#include "kernels/light_test.h"
#include "line/test_visibility.h"
#include "reference/direct_ref.h"
#include "reference/tolerances.h"
#include "reference/transport_ref.h"

namespace {

using namespace pencil;
using namespace pencil::test;

struct Lit {
    HostSurfels surfels;
    std::vector<float> outgoing;
    std::vector<uint> mask;
};

/// Light added to `start` everywhere.
Lit light(const TestScene& scene, const std::vector<LightSample>& samples, int limit, int n, float start, Random& random) {
    Kernels kernels = make_kernels();
    const DeviceScene on_device(device(), scene.flat);
    LightSet lights(device(), samples, n);
    rasterize_octahedral(kernels, on_device, lights.maps, 0, lights.maps.count);
    const Surfels surfels = gathered(kernels, on_device, random_centres(random, 3), 16, limit);
    Buffer<float> outgoing(device(), std::vector<float>(static_cast<std::size_t>(surfels.capacity) * 3, start), "outgoing");
    light_surfels(kernels, on_device, surfels, lights, outgoing, "test");
    Buffer<uint> mask(device(), static_cast<std::size_t>(mask_words(lights.maps.count)) * static_cast<std::size_t>(surfels.capacity),
                      "mask");
    test_visibility(kernels, on_device, surfels, lights.maps, mask);
    return {HostSurfels(surfels), outgoing.read(), mask.read()};
}

TEST(LightSurfels, EmptyBox) {
    Random random(91);
    const TestScene scene = box_scene(92);
    for (const int limit : {1, 37, 700}) {
        for (const int count : {1, 33}) {
            const std::vector<LightSample> samples = random_lights(random, count);
            const Lit lit = light(scene, samples, limit, 16, 0.0F, random);
            for (int i = 0; i < lit.surfels.count; ++i) {
                const ref::DirectLight e =
                    ref::direct_irradiance(samples, scene.triangles, lit.surfels.position(i), lit.surfels.normal(i), lit.surfels.plane(i));
                const dvec3 expected = ref::scattered_radiance(lit.surfels.albedo(i), e.irradiance);
                expect_close(rgb_at(lit.outgoing, lit.surfels.capacity, i), expected, tolerance::accumulation,
                             "surfel " + std::to_string(i));
            }
        }
    }
}

TEST(LightSurfels, AmongOccludersWithTheMapsVisibility) {
    Random random(93);
    const TestScene scene = room_scene(94, 25);
    for (const int count : {1, 7, 65}) {
        const std::vector<LightSample> samples = random_lights(random, count);
        const Lit lit = light(scene, samples, 700, 32, 0.5F, random);
        int hidden = 0;
        for (int i = 0; i < lit.surfels.count; ++i) {
            dvec3 e(0.0);
            for (int s = 0; s < count; ++s) {
                const uint word = lit.mask[static_cast<std::size_t>(s / 32) * lit.surfels.capacity + static_cast<std::size_t>(i)];
                const dvec3 one =
                    ref::sample_irradiance(samples[static_cast<std::size_t>(s)], lit.surfels.position(i), lit.surfels.normal(i));
                if ((word >> (s % 32) & 1U) != 0U)
                    e += one;
                else
                    hidden += one.x > 0.0 ? 1 : 0;
            }
            const dvec3 expected = dvec3(0.5) + ref::scattered_radiance(lit.surfels.albedo(i), e);
            expect_close(rgb_at(lit.outgoing, lit.surfels.capacity, i), expected, tolerance::accumulation, "surfel " + std::to_string(i));
        }
        EXPECT_GT(hidden, 10) << "the occluders hide nothing";
    }
}

TEST(LightSurfels, RaysSettleOccludersExactly) {
    RayRoom room(97, 60, 9);
    Buffer<float> outgoing = surfel_rgb(device(), room.surfels.capacity, "outgoing");
    light_surfels(room.kernels, room.on_device, room.surfels, room.lights, outgoing, "test");
    const HostSurfels host(room.surfels);
    const std::vector<float> rgb = outgoing.read();
    int compared = 0;
    for (int i = 0; i < host.count; ++i) {
        const ref::DirectLight e =
            ref::direct_irradiance(room.samples, room.scene.triangles, host.position(i), host.normal(i), host.plane(i));
        if (e.margin <= 1e-5) continue;  // a ray along an edge
        ++compared;
        expect_close(rgb_at(rgb, host.capacity, i), ref::scattered_radiance(host.albedo(i), e.irradiance), tolerance::accumulation,
                     "surfel " + std::to_string(i));
    }
    EXPECT_GT(compared, 700);
}

TEST(LightSurfels, BoundedAtTheLight) {
    // A light sample right above a surface: radiance tends to that of the emitter, E <= pi L, however near it is.
    Random random(95);
    const TestScene scene = box_scene(96);
    LightSample s{};
    s.position = to_float4({0.1, -0.75 + 1e-4, 0.2}, 1.0);
    s.normal = to_float4({0, -1, 0}, 0.04 / ref::pi);
    s.emission = to_float4(dvec3(0.04), -1.0);  // radiance 1
    const Lit lit = light(scene, {s}, 768, 16, 0.0F, random);
    for (int i = 0; i < lit.surfels.count; ++i) {
        ASSERT_LE(rgb_at(lit.outgoing, lit.surfels.capacity, i).x, lit.surfels.albedo(i).x * (1.0 + tolerance::accumulation))
            << "surfel " << i;
    }
}

}  // namespace
