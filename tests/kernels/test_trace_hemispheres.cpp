// Hemispheres of surface pencils: rays through the hierarchy meet what brute force meets, directions are cosine-distributed about the
// normal, and sums over them are irradiance.
#include "kernel_test.h"
#include "transport/surface_pencils.h"

namespace {

using namespace pencil;
using namespace pencil::test;

struct Traced {
    SurfacePencils pencils;
    Surfels surfels;
    Buffer<float> distances;
};

std::vector<SurfacePencil> random_pencils(std::uint32_t seed, int count) {
    Random random(seed);
    std::vector<SurfacePencil> pencils;
    for (int i = 0; i < count; ++i) {
        const dvec3 normal = random.direction();
        SurfacePencil p{};
        p.position = to_float4(random.in_box(-0.7, 0.7));
        p.normal = to_float4(normal, 0.1);
        p.facing = to_float4(normal);
        pencils.push_back(p);
    }
    return pencils;
}

Traced trace(Kernels& kernels, const TestScene& scene, const std::vector<SurfacePencil>& placed, int n) {
    const DeviceScene on_device(device(), scene.flat);
    const DeviceBvh bvh(device(), build_bvh(scene.flat.triangles));
    const int count = static_cast<int>(placed.size());
    Traced t{SurfacePencils(device(), count, n), Surfels(device(), count * n * n, "surfels"), Buffer<float>()};
    t.distances = Buffer<float>(device(), static_cast<std::size_t>(t.surfels.capacity), "distances");
    t.pencils.data.write(placed);
    t.pencils.count = count;
    trace_hemispheres(kernels, on_device, bvh, t.pencils, 0, count, 7, t.surfels, t.distances);
    return t;
}

float field(const std::vector<float>& surfels, int capacity, int f, std::size_t i) {
    return surfels[static_cast<std::size_t>(f) * static_cast<std::size_t>(capacity) + i];
}

TEST(TraceHemispheres, MeetsWhatBruteForceMeets) {
    Kernels kernels = make_kernels();
    for (const int things : {0, 1, 40, 3000}) {
        const TestScene scene = room_scene(static_cast<std::uint32_t>(things) + 3, things);
        const std::vector<SurfacePencil> placed = random_pencils(5, 3);
        const int n = 8;
        const Traced t = trace(kernels, scene, placed, n);
        const std::vector<float> surfels = t.surfels.data.read(), distances = t.distances.read();
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < placed.size() * n * n; ++i) {
            const dvec3 origin = xyz(placed[i / (n * n)].position);
            const dvec3 point(field(surfels, t.surfels.capacity, SURFEL_X, i), field(surfels, t.surfels.capacity, SURFEL_Y, i),
                              field(surfels, t.surfels.capacity, SURFEL_Z, i));
            ASSERT_LT(distances[i], 4.0F) << "a closed room: every ray meets something";
            EXPECT_NEAR(glm::distance(origin, point), distances[i], 1e-5);
            const ref::RayHit hit = ref::nearest_triangle(scene.triangles, origin, glm::normalize(point - origin));
            if (std::abs(hit.t - static_cast<double>(distances[i])) > 1e-4) ++wrong;
        }
        EXPECT_LE(wrong, 1U) << things << " things: at most one ray along an edge may differ";
    }
}

TEST(TraceHemispheres, DirectionsFollowTheCosine) {
    Kernels kernels = make_kernels();
    const TestScene scene = box_scene(1);
    const std::vector<SurfacePencil> placed = random_pencils(9, 16);
    for (const int n : {4, 8, 16, 32}) {
        const Traced t = trace(kernels, scene, placed, n);
        const std::vector<float> surfels = t.surfels.data.read();
        double all = 0;
        for (std::size_t p = 0; p < placed.size(); ++p) {
            double cosine = 0, least = 1;
            dvec3 tangential(0);
            for (std::size_t i = p * n * n; i < (p + 1) * n * n; ++i) {
                const dvec3 point(field(surfels, t.surfels.capacity, SURFEL_X, i), field(surfels, t.surfels.capacity, SURFEL_Y, i),
                                  field(surfels, t.surfels.capacity, SURFEL_Z, i));
                const dvec3 d = glm::normalize(point - xyz(placed[p].position)), normal = xyz(placed[p].normal);
                cosine += glm::dot(d, normal) / (n * n);
                least = std::min(least, glm::dot(d, normal));
                tangential += (d - glm::dot(d, normal) * normal) / static_cast<double>(n * n);
            }
            // The cosine has the mean 2/3 and the variance 1/18; strata only lower the error of n * n samples.
            EXPECT_NEAR(cosine, 2.0 / 3.0, 3.0 * std::sqrt(1.0 / 18.0) / n) << "n = " << n;
            all += cosine / static_cast<double>(placed.size());
            EXPECT_LT(glm::length(tangential), 0.6 / n) << "n = " << n;
            EXPECT_GE(least, -1e-4);
        }
        EXPECT_NEAR(all, 2.0 / 3.0, 3.0 * std::sqrt(1.0 / 18.0 / static_cast<double>(placed.size())) / n) << "mean of all, n = " << n;
    }
}

TEST(SumHemispheres, UniformRadianceIsPi) {
    Kernels kernels = make_kernels();
    const TestScene scene = box_scene(2);
    const std::vector<SurfacePencil> placed = random_pencils(11, 5);
    Traced t = trace(kernels, scene, placed, 8);
    const Buffer<float> radiance(device(), std::vector<float>(3 * static_cast<std::size_t>(t.surfels.capacity), 2.0F), "radiance");
    sum_hemispheres(kernels, radiance, t.distances, t.surfels.capacity, 0, t.pencils.count, t.pencils);
    const std::vector<float> distances = t.distances.read();
    const std::vector<SurfacePencil> summed = t.pencils.data.read();
    for (std::size_t p = 0; p < placed.size(); ++p) {
        EXPECT_NEAR(summed[p].irradiance.x, 2.0 * ref::pi, 1e-4);
        double inverse = 0;
        for (std::size_t i = p * 64; i < (p + 1) * 64; ++i) inverse += 1.0 / static_cast<double>(distances[i]) / 64.0;
        EXPECT_NEAR(summed[p].position.w, 1.0 / inverse, 1e-4 / inverse) << "harmonic mean";
        for (const float ring : summed[p].ring) EXPECT_LT(ring, 4.0F) << "the room bounds the horizon";
    }
}

}  // namespace
