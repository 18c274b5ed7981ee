// Rays towards bright spots and the share that they leave to texels: together they are the irradiance in the mean, with less noise.
#include <cmath>

#include "kernels/surface_test.h"
#include "reference/tolerances.h"
#include "surface/guide_hemispheres.h"
#include "surface/share_hemispheres.h"
#include "surface/sum_guides.h"
#include "surface/sum_hemispheres.h"

namespace {

using namespace pencil;
using namespace pencil::test;

constexpr int map_width = 8;

/// Radiance of what is met: 1, and much more near a place on a wall.
double radiance_of(const dvec3& x) { return glm::distance(x, dvec3(0.75, 0.2, 0.1)) < 0.1 ? 200.0 : 1.0; }

Buffer<float> radiance_of(const Surfels& surfels) {
    const HostSurfels host(surfels);
    std::vector<float> rgb(3 * static_cast<std::size_t>(surfels.capacity), 0.0F);
    for (int i = 0; i < surfels.count; ++i) {
        if (host.plane(i) < 0) continue;
        for (int c = 0; c < 3; ++c)
            rgb[static_cast<std::size_t>(c * surfels.capacity + i)] = static_cast<float>(radiance_of(host.position(i)) * (c + 1));
    }
    return Buffer<float>(device(), rgb, "radiance");
}

/// Mean and variance of the irradiance of each pencil over turns.
struct Irradiance {
    std::vector<double> mean, variance;
};

Irradiance irradiance(const std::vector<SurfacePencil>& placed, const std::vector<Spot>& found, int turns) {
    Kernels kernels = make_kernels();
    const TestScene scene = box_scene(1);
    const DeviceScene on_device(device(), scene.flat, build_bvh(scene.flat.triangles));
    const int count = static_cast<int>(placed.size());
    const DeviceSpots spots(device(), found);
    SurfacePencils pencils(device(), count, map_width);
    pencils.data.write(placed);
    pencils.count = count;
    Surfels seen(device(), count * map_width * map_width, "surfels"), guided(device(), count * SPOT_RAYS, "guided surfels");
    Buffer<float> factors(device(), static_cast<std::size_t>(guided.capacity), "factors");
    Irradiance out{std::vector<double>(placed.size(), 0.0), std::vector<double>(placed.size(), 0.0)};
    for (int turn = 0; turn < turns; ++turn) {
        const TexelPoints points{5, static_cast<uint>(turn)};
        trace_hemispheres(kernels, on_device, pencils, 0, count, points, seen);
        Buffer<float> radiance = radiance_of(seen);
        if (spots.count > 0) share_hemispheres(kernels, pencils, 0, count, spots, points, radiance, seen.capacity);
        sum_hemispheres(kernels, radiance, seen.capacity, 0, 0, count, map_width, pencils.irradiance);
        if (spots.count > 0) {
            guide_hemispheres(kernels, on_device, pencils, 0, count, spots, points, guided, factors);
            sum_guides(kernels, radiance_of(guided), guided.capacity, factors, SPOT_RAYS, 0, count, pencils.irradiance);
        }
        const std::vector<float4> e = pencils.irradiance.read();
        for (std::size_t p = 0; p < placed.size(); ++p) {
            const auto value = static_cast<double>(e[p].x);
            EXPECT_NEAR(static_cast<double>(e[p].z), 3 * value, 1e-3 * value);
            out.mean[p] += value / turns;
            out.variance[p] += value * value / turns;
        }
    }
    for (std::size_t p = 0; p < placed.size(); ++p) out.variance[p] = std::max(out.variance[p] - out.mean[p] * out.mean[p], 0.0);
    return out;
}

TEST(GuideHemispheres, KeepsTheMeanAndTakesTheNoise) {
    const std::vector<SurfacePencil> placed = random_pencils(3, 11);
    constexpr int turns = 512;
    const Irradiance texels = irradiance(placed, {}, 4 * turns);
    // Spots where the light is, beside it, behind some of the pencils, and around one of them.
    const std::vector<Spot> spots{{{0.75F, 0.2F, 0.1F}, 0.15F, 5.0F},   {{0.75F, 0.4F, 0.1F}, 0.1F, 1.0F},
                                  {{-0.75F, -0.7F, 0.0F}, 0.01F, 1.0F}, {glm::vec3(xyz(placed[2].position)), 0.3F, 3.0F},
                                  {{0.7F, 0.25F, 0.1F}, 0.1F, 0.2F},    {{0.0F, 0.75F, 0.0F}, 0.2F, 0.3F},
                                  {{0.0F, -0.75F, 0.0F}, 0.2F, 0.1F},   {{0.0F, 0.0F, 0.75F}, 0.2F, 0.05F}};
    const Irradiance guided = irradiance(placed, spots, turns);
    double before = 0, after = 0;
    for (std::size_t p = 0; p < placed.size(); ++p) {
        const double noise = std::sqrt(texels.variance[p] / (4 * turns) + guided.variance[p] / turns);
        EXPECT_NEAR(guided.mean[p], texels.mean[p], 4 * noise + 1e-4 * texels.mean[p]) << "pencil " << p;
        before += texels.variance[p];
        after += guided.variance[p];
    }
    EXPECT_LT(after, 0.2 * before) << "variance " << before << " became " << after;
}

TEST(GuideHemispheres, RaysBelowTheHorizonSeeNothing) {
    std::vector<SurfacePencil> placed = random_pencils(3, 5);
    for (SurfacePencil& p : placed) p.facing = -p.normal;
    Kernels kernels = make_kernels();
    const TestScene scene = box_scene(1);
    const DeviceScene on_device(device(), scene.flat, build_bvh(scene.flat.triangles));
    SurfacePencils pencils(device(), 5, map_width);
    pencils.data.write(placed);
    pencils.count = 5;
    Surfels guided(device(), 5 * SPOT_RAYS, "guided surfels");
    Buffer<float> factors(device(), static_cast<std::size_t>(guided.capacity), "factors");
    guide_hemispheres(kernels, on_device, pencils, 0, 5, DeviceSpots(device(), {{{0.75F, 0.2F, 0.1F}, 0.15F, 5.0F}}), {7}, guided, factors);
    EXPECT_EQ(guided.count, 5 * SPOT_RAYS);
    const std::vector<float> got = factors.read();
    const HostSurfels surfels(guided);
    for (int i = 0; i < guided.count; ++i) {
        EXPECT_EQ(got[static_cast<std::size_t>(i)], 0.0F);
        EXPECT_LT(surfels.plane(i), 0);
    }
}

/// Pencils that look from several places receive the mean of what they would receive from each.
TEST(GuideHemispheres, PlacesOfAPencilCountEvenly) {
    constexpr int places = 4, count = 3, rays = places * SPOT_RAYS;
    Kernels kernels = make_kernels();
    Random random(3);
    std::vector<float> radiance, factors;
    for (int i = 0; i < 3 * count * rays; ++i) radiance.push_back(static_cast<float>(random.uniform(0, 5)));
    for (int i = 0; i < count * rays; ++i) factors.push_back(static_cast<float>(random.uniform(0, 0.1)));
    const Buffer<float> on_device(device(), radiance, "radiance"), of_rays(device(), factors, "factors");
    Buffer<float4> irradiance(device(), std::vector<float4>(count, float4(1, 2, 3, 0)), "irradiance");
    sum_guides(kernels, on_device, count * rays, of_rays, rays, 0, count, irradiance);
    const std::vector<float4> got = irradiance.read();
    for (int p = 0; p < count; ++p)
        for (int c = 0; c < 3; ++c) {
            double sum = 0;
            for (int i = p * rays; i < (p + 1) * rays; ++i)
                sum += static_cast<double>(factors[static_cast<std::size_t>(i)]) *
                       static_cast<double>(radiance[static_cast<std::size_t>(c * count * rays + i)]);
            EXPECT_NEAR(static_cast<double>(got[static_cast<std::size_t>(p)][c]), c + 1 + sum / places, 1e-4 * sum);
        }
}

}  // namespace
