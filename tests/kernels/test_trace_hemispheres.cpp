// Hemispheres of surface pencils: each texel is seen through a point of its own, rays through the hierarchy meet what brute force meets,
// and directions are cosine-distributed about the normal.
#include <glm/common.hpp>

#include "kernels/surface_test.h"
#include "reference/hemisphere_ref.h"
#include "reference/tolerances.h"
#include "surface/measure_hemispheres.h"
#include "surface/place_surface_pencils.h"
#include "surface/trace_hemispheres.h"

namespace {

using namespace pencil;
using namespace pencil::test;

struct Traced {
    SurfacePencils pencils;
    Surfels surfels;
};

Traced trace(Kernels& kernels, const TestScene& scene, const std::vector<SurfacePencil>& placed, int n, const TexelPoints& points = {7}) {
    const DeviceScene on_device(device(), scene.flat, build_bvh(scene.flat.triangles));
    const int count = static_cast<int>(placed.size());
    Traced t{SurfacePencils(device(), count, n), Surfels(device(), count * n * n, "surfels")};
    t.pencils.data.write(placed);
    t.pencils.count = count;
    trace_hemispheres(kernels, on_device, t.pencils, 0, count, points, t.surfels);
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
        const std::vector<float> surfels = t.surfels.data.read();
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < placed.size() * n * n; ++i) {
            const dvec3 origin = xyz(placed[i / (n * n)].position);
            const dvec3 point(field(surfels, t.surfels.capacity, SURFEL_X, i), field(surfels, t.surfels.capacity, SURFEL_Y, i),
                              field(surfels, t.surfels.capacity, SURFEL_Z, i));
            ASSERT_NE(glm::floatBitsToInt(field(surfels, t.surfels.capacity, SURFEL_PLANE, i)), -1) << "every ray meets something";
            const ref::RayHit hit = ref::nearest_triangle(scene.triangles, origin, glm::normalize(point - origin));
            if (std::abs(hit.t - glm::distance(origin, point)) > 1e-4) ++wrong;
        }
        EXPECT_LE(wrong, 1U) << things << " things: at most one ray along an edge may differ";
    }
}

/// Points seen, taken back through the tangent frame and the concentric map, lie in their texels.
TEST(TraceHemispheres, EveryTexelIsSeenThroughAPointOfItsOwn) {
    Kernels kernels = make_kernels();
    const TestScene scene = box_scene(1);
    for (const int count : {1, 5, 37})
        for (const int n : {4, 8, 12}) {
            const std::vector<SurfacePencil> placed = random_pencils(static_cast<std::uint32_t>(count), count);
            const Traced t = trace(kernels, scene, placed, n);
            const HostSurfels surfels(t.surfels);
            ASSERT_EQ(surfels.count, count * n * n);
            for (int i = 0; i < surfels.count; ++i) {
                const SurfacePencil& p = placed[static_cast<std::size_t>(i / (n * n))];
                const dvec3 d = glm::normalize(surfels.position(i) - xyz(p.position));
                const ref::TangentFrame frame(xyz(p.normal));
                const ref::dvec2 square = ref::disc_to_square(glm::dot(d, frame.t), glm::dot(d, frame.b));
                const ref::Texel texel = ref::hemisphere_texel(i % (n * n), n);
                const double x = (square.x + 1) * 0.5 * n - texel.x, y = (square.y + 1) * 0.5 * n - texel.y;
                for (const double within : {x, y}) {
                    ASSERT_GT(within, -tolerance::decision) << "texel " << i % (n * n) << " of pencil " << i / (n * n) << ", n " << n;
                    ASSERT_LT(within, 1 + tolerance::decision) << "texel " << i % (n * n) << " of pencil " << i / (n * n) << ", n " << n;
                }
            }
        }
}

/// A range of a set is traced as the whole set is, and nothing else is written.
TEST(TraceHemispheres, RangesAreTracedAlike) {
    Kernels kernels = make_kernels();
    const TestScene scene = room_scene(4, 20);
    const DeviceScene on_scene(device(), scene.flat, build_bvh(scene.flat.triangles));
    const std::vector<SurfacePencil> placed = random_pencils(5, 9);
    const Traced all = trace(kernels, scene, placed, 4);
    const MadeSurfels nothing(7 * 16);
    Surfels part = nothing.on_device();
    trace_hemispheres(kernels, on_scene, all.pencils, 3, 5, {7}, part, 16);
    EXPECT_EQ(part.count, 6 * 16);
    part.count = part.capacity;
    const HostSurfels got(part), expected(all.surfels);
    for (int f = 0; f < SURFEL_FIELDS; ++f)
        for (int i = 0; i < got.count; ++i) {
            const int from = i - 16 + 3 * 16;
            const bool written = i >= 16 && i < 6 * 16;
            ASSERT_EQ(got.bits(f, i), written ? expected.bits(f, from) : nothing.bits(f, i)) << "field " << f << " of surfel " << i;
        }
}

TEST(TraceHemispheres, NothingIsSeenBelowTheGeometricHorizonNorOnItsOwnPlane) {
    Kernels kernels = make_kernels();
    Random random(6);
    std::vector<SurfacePencil> placed = random_pencils(7, 37);
    for (SurfacePencil& p : placed) {
        p.facing = to_float4(glm::normalize(xyz(p.normal) + 0.9 * random.direction()));
        p.plane = random.index(6);
    }
    const Traced t = trace(kernels, box_scene(1), placed, 8);
    const HostSurfels surfels(t.surfels);
    int nothing = 0;
    for (int i = 0; i < surfels.count; ++i) {
        const SurfacePencil& p = placed[static_cast<std::size_t>(i / 64)];
        nothing += surfels.plane(i) < 0 ? 1 : 0;
        if (surfels.plane(i) < 0) continue;
        EXPECT_NE(surfels.plane(i), p.plane) << "texel " << i;
        EXPECT_GT(glm::dot(surfels.position(i) - xyz(p.position), xyz(p.facing)), -1e-6) << "texel " << i;
    }
    EXPECT_GT(nothing, 100);
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

/// Mean square error, over pencils, of the mean cosine of their directions in `sets` sets of points.
template <typename Points>
double cosine_error(Kernels& kernels, int sets, Points points_of) {
    const TestScene scene = box_scene(1);
    const std::vector<SurfacePencil> placed = random_pencils(9, 64);
    std::vector<double> cosine(placed.size(), 0.0);
    for (uint set = 0; set < static_cast<uint>(sets); ++set) {
        const Traced t = trace(kernels, scene, placed, 4, points_of(set));
        const std::vector<float> surfels = t.surfels.data.read();
        for (std::size_t i = 0; i < 16 * placed.size(); ++i) {
            const dvec3 point(field(surfels, t.surfels.capacity, SURFEL_X, i), field(surfels, t.surfels.capacity, SURFEL_Y, i),
                              field(surfels, t.surfels.capacity, SURFEL_Z, i));
            cosine[i / 16] += glm::dot(glm::normalize(point - xyz(placed[i / 16].position)), xyz(placed[i / 16].normal)) / (16.0 * sets);
        }
    }
    double error = 0;
    for (const double c : cosine) error += (c - 2.0 / 3.0) * (c - 2.0 / 3.0) / static_cast<double>(cosine.size());
    return error;
}

TEST(TraceHemispheres, TurnsFillTexelsMoreEvenlyThanSeeds) {
    Kernels kernels = make_kernels();
    const double seeds = cosine_error(
        kernels, 64,
        [](uint set) {
            return TexelPoints{set + 1, 0};
        });
    const double turns = cosine_error(kernels, 64, [](uint set) { return TexelPoints{1, set}; });
    std::printf("mean square error of the mean cosine: 64 seeds %.2e, 64 turns %.2e\n", seeds, turns);
    EXPECT_LT(turns, 0.2 * seeds);
    EXPECT_GT(turns, 0.0);
}

/// The pencil that place_surface_pencils makes of a surfel of a floor (y = 0, seen from above) at x, seen from `eye`.
Traced on_floor(Kernels& kernels, const TestScene& scene, const dvec3& x, const dvec3& eye, int n) {
    Surfels surfels(device(), 1, "surfel");
    std::vector<float> values(static_cast<std::size_t>(surfels.capacity) * SURFEL_FIELDS, 0.0F);
    const auto set = [&](int f, float v) { values[static_cast<std::size_t>(f) * static_cast<std::size_t>(surfels.capacity)] = v; };
    set(SURFEL_X, static_cast<float>(x.x));
    set(SURFEL_Y, static_cast<float>(x.y));
    set(SURFEL_Z, static_cast<float>(x.z));
    set(SURFEL_NY, 1.0F);
    set(SURFEL_GY, 1.0F);
    set(SURFEL_PLANE, glm::intBitsToFloat(scene.flat.triangles.front().plane));
    surfels.data.write(values);
    SurfacePencils pencils(device(), 1, n);
    ChosenSurfels chosen;
    chosen.add(0, 0, glm::vec3(eye), 0.1F);
    place_surface_pencils(kernels, surfels, chosen, pencils);
    Traced t = trace(kernels, scene, pencils.data.read(0, 1), n);
    measure_hemispheres(kernels, t.surfels, 0, 0, 1, t.pencils);
    return t;
}

/// A floor, y = 0, and a wall x = 0 that stands on it.
TestScene floor_and_wall() {
    const dvec3 a(-1, 0, -1), b(-1, 0, 1), c(1, 0, 1), d(1, 0, -1), e(0, 0, -1), f(0, 1, -1), g(0, 1, 1), h(0, 0, 1);
    return make_scene({{a, b, c, 0}, {a, c, d, 0}, {e, f, g, 1}, {e, g, h, 1}}, 4, 1);
}

TEST(TraceHemispheres, ThePencilInACreaseSeesTheWallAndNothingBehindIt) {
    Kernels kernels = make_kernels();
    const TestScene scene = floor_and_wall();
    const int wall = scene.flat.triangles.back().plane, n = 16;
    for (const double side : {-0.5, 0.5}) {
        const Traced t = on_floor(kernels, scene, {0, 0, 0.1}, {side, 0.5, 0.3}, n);
        const std::vector<float> surfels = t.surfels.data.read();
        const SurfacePencil pencil = t.pencils.data.read(0, 1).front();
        EXPECT_GT(static_cast<double>(pencil.position.x) * side, 0.0) << "on the side that was seen";
        int seen = 0;
        for (std::size_t i = 0; i < n * n; ++i)
            seen += glm::floatBitsToInt(field(surfels, t.surfels.capacity, SURFEL_PLANE, i)) == wall ? 1 : 0;
        // Half of the directions, but for those above the wall's edges.
        EXPECT_GT(seen, n * n / 2 - 2 * n) << "eye at x = " << side;
        EXPECT_LE(seen, n * n / 2 + n) << "eye at x = " << side;
    }
}

TEST(MeasureHemispheres, TheHorizonEndsAtTheWall) {
    Kernels kernels = make_kernels();
    const Traced t = on_floor(kernels, floor_and_wall(), {0.2, 0, 0}, {0.5, 0.5, 0.0}, 16);
    const SurfacePencil p = t.pencils.data.read(0, 1).front();
    // tangent_frame of (0, 1, 0)
    const dvec3 tangent(1, 0, 0), bitangent(0, 0, -1);
    const auto clear = [&](const dvec3& step) {
        const double x = glm::dot(step, tangent), y = glm::dot(step, bitangent);
        const int sector = (x < 0 ? 4 : 0) | (y < 0 ? 2 : 0) | (std::abs(x) < std::abs(y) ? 1 : 0);
        return x * static_cast<double>(p.horizon_x[sector]) + y * static_cast<double>(p.horizon_y[sector]) < 1.0;
    };
    for (const double z : {-0.15, -0.05, 0.05, 0.15}) {
        EXPECT_TRUE(clear({-0.19, 0, z})) << "before the wall, z = " << z;
        EXPECT_FALSE(clear({-0.21, 0, z})) << "behind the wall, z = " << z;
        EXPECT_TRUE(clear({0.6, 0, z})) << "away from it, z = " << z;
    }
}

}  // namespace
