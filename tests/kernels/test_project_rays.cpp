// Rays of surfels beside the lines of pencils: what rays find against a brute-force cast, and the cells of both against brute force.
#include <glm/common.hpp>
#include <memory>

#include "kernels/kernel_test.h"
#include "line/project_pencils.h"
#include "line/project_rays.h"
#include "pencils/build_bvh.h"
#include "pencils/cell_directions.h"
#include "reference/power_ref.h"
#include "reference/tolerances.h"
#include "reference/voronoi_ref.h"

namespace {

using namespace pencil;
using namespace pencil::test;

constexpr int ray_side = 4, ray_count = ray_side * ray_side, map = 32;
constexpr double half = 1.0;  // of the box of centres, around the walls

CentreSpace test_space() { return {glm::dvec3(-half), glm::dvec3(half), 3.0}; }

/// One colour per plane.
dvec3 colour_of(int plane) { return {0.1 + plane, 0.5 + 0.25 * (plane % 7), 1.0 + plane % 3}; }

/// A scene with pencils whose maps hold the colour of the plane that light comes from, projected with rays.
struct RayScene {
    /// `stretch`: how much is done at once; `found` holds the rays of the last.
    RayScene(TestScene test_scene, int pencils, int limit, std::uint32_t seed, const RayStretch& stretch = {1 << 20, 1 << 20})
        : scene(std::move(test_scene)) {
        Random random(seed);
        Features features;
        features.weights = PENCIL_WEIGHTS_POWER;
        features.cell_grid = largest_cell_grid(pencils + ray_count);
        Kernels kernels(device(), features);
        const DeviceScene on_device(device(), scene.flat, build_bvh(scene.flat.triangles));
        centres = random_centres(random, pencils, 0.6);
        const auto maps = std::make_shared<GeometryMaps>(rasterized(kernels, on_device, centres, map));
        PencilSet set(device(), maps);
        set.radiance.write(coloured_tiles());
        const Surfels surfels = gathered(kernels, on_device, random_centres(random, 3, 0.6), 16, limit);
        host = std::make_unique<HostSurfels>(surfels);
        WeightTables tables(kernels);
        Buffer<float> by_rays = surfel_rgb(device(), surfels.capacity, "outgoing by rays alone");
        Buffer<float> outgoing = surfel_rgb(device(), surfels.capacity, "outgoing");
        Buffer<int> visible(device(), host->capacity, "visible");
        for (int first = 0; first < surfels.count; first += stretch.surfels) {
            const int end = std::min(first + stretch.surfels, surfels.count);
            project_rays(kernels, on_device, surfels, first, end, set, test_space(), {ray_side, seed, 0}, stretch, tables.rays());
            project_pencils(kernels, on_device, surfels, first, end, set, tables, outgoing, visible, "test");
            sum_rays(kernels, surfels, first, end, tables.rays(), by_rays);
        }
        alone = by_rays.read();
        ray_capacity = static_cast<std::size_t>(tables.rays().capacity);
        found = tables.rays().data.read();
        after = outgoing.read();
    }

    ref::RayHit cast(const dvec3& from, const dvec3& direction) const { return ref::nearest_triangle(scene.triangles, from, direction); }
    int plane_of(const ref::RayHit& hit) const {
        return hit.triangle < 0 ? -1 : scene.triangles[static_cast<std::size_t>(hit.triangle)].plane;
    }
    float ray(int surfel, int k, int field) const {
        return found[static_cast<std::size_t>(k * RAY_FIELDS + field) * ray_capacity + static_cast<std::size_t>(surfel)];
    }
    dvec3 ray_direction(int surfel, int k) const {
        const double x = ray(surfel, k, RAY_TANGENT), y = ray(surfel, k, RAY_BITANGENT);
        return ref::Frame(host->normal(surfel)).to_world({x, y, std::sqrt(std::max(1.0 - x * x - y * y, 0.0))});
    }
    dvec3 ray_light(int surfel, int k) const { return {ray(surfel, k, RAY_R), ray(surfel, k, RAY_G), ray(surfel, k, RAY_B)}; }

    TestScene scene;
    std::vector<float4> centres;
    std::unique_ptr<HostSurfels> host;
    std::size_t ray_capacity = 0;
    std::vector<float> found, after, alone;  // fields of rays; radiance by lines and rays, and by rays

private:
    std::vector<float4> coloured_tiles() const {
        std::vector<float4> out(centres.size() * static_cast<std::size_t>(PENCIL_TILE_TEXELS(map)));
        for (std::size_t tile = 0; tile < centres.size(); ++tile)
            for (int y = -1; y <= map; ++y)
                for (int x = -1; x <= map; ++x) {
                    const ref::Texel t = ref::fold(x, y, map);
                    const dvec3 onwards = ref::oct_to_direction({(2 * t.x + 1.0) / map - 1.0, (2 * t.y + 1.0) / map - 1.0});
                    const ref::RayHit hit = cast(xyz(centres[tile]), -onwards);
                    const dvec3 light = hit.triangle < 0 ? dvec3(0.0) : colour_of(plane_of(hit));
                    out[atlas_index(static_cast<int>(tile), x, y, map)] = to_float4(light, 1.0);
                }
        return out;
    }
};

/// Distance to the end of the box of centres.
double box_exit(const dvec3& from, const dvec3& direction) {
    double exit = 1e9;
    for (int k = 0; k < 3; ++k)
        if (direction[k] != 0.0) exit = std::min(exit, (std::copysign(half, direction[k]) - from[k]) / direction[k]);
    return exit;
}

void check_rays(const RayScene& s, double most_lost) {
    int sent = 0, lost = 0;
    for (int i = 0; i < s.host->count; ++i) {
        if (s.host->plane(i) < 0) continue;
        for (int k = 0; k < ray_count; ++k) {
            ++sent;
            const dvec3 direction = s.ray_direction(i, k), from = s.host->position(i) + 1e-6 * s.host->normal(i);
            const ref::RayHit hit = s.cast(from, direction);
            if (hit.margin < 1e-4 || hit.t < 1e-3) continue;
            if (s.ray(i, k, RAY_RADIUS) < 0) {
                ++lost;
                ASSERT_GE(hit.triangle, 0) << "a ray that meets nothing finds darkness";
                continue;
            }
            const dvec3 expected = hit.triangle < 0 ? dvec3(0.0) : colour_of(s.plane_of(hit));
            ASSERT_LE(glm::length(s.ray_light(i, k) - expected), 1e-4)
                << "surfel " << i << " ray " << k << " meets plane " << s.plane_of(hit) << " and finds " << s.ray_light(i, k).x;
            const double path = std::min(hit.t, box_exit(from, direction)), cosine = glm::dot(direction, s.host->normal(i));
            const double density =
                ref::line_and_ray_density(path, cosine, static_cast<int>(s.centres.size()), test_space().volume, ray_count);
            ASSERT_NEAR(s.ray(i, k, RAY_RADIUS), ref::disc_radius(density, ray_count), 1e-4) << "surfel " << i << " ray " << k;
        }
    }
    ASSERT_GT(sent, 1000);
    EXPECT_LE(lost, most_lost * sent) << "rays of which no pencil shows the end";
}

TEST(ProjectRays, FindTheLightOfWhatTheyMeet) {
    check_rays(RayScene(box_scene(131), 24, 400, 1), 0.002);
    check_rays(RayScene(room_scene(132, 12), 48, 500, 2), 0.15);
}

TEST(ProjectRays, AloneAreTheMeanOfThoseThatFindLight) {
    const RayScene s(room_scene(137, 12), 12, 500, 7);
    int lost = 0;
    for (int i = 0; i < s.host->count; ++i) {
        dvec3 sum(0.0);
        int known = 0;
        for (int k = 0; k < ray_count; ++k) {
            if (s.ray(i, k, RAY_RADIUS) < 0) continue;
            sum += s.ray_light(i, k);
            ++known;
        }
        lost += ray_count - known;
        const dvec3 expected = known == 0 ? dvec3(0.0) : s.host->albedo(i) * sum / static_cast<double>(known);
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(s.alone[static_cast<std::size_t>(c) * s.host->capacity + static_cast<std::size_t>(i)], expected[c], 1e-5);
    }
    EXPECT_GT(lost, 0) << "the case of rays that find none is not tested";
}

TEST(ProjectRays, StrataHoldOneRayEach) {
    const RayScene s(box_scene(133), 4, 200, 3);
    for (int i = 0; i < s.host->count; ++i) {
        int quadrants[4] = {0, 0, 0, 0};
        for (int k = 0; k < ray_count; ++k) {
            const double x = s.ray(i, k, RAY_TANGENT), y = s.ray(i, k, RAY_BITANGENT);
            ASSERT_LE(x * x + y * y, 1.0 + 1e-5);
            ++quadrants[(x < 0.0 ? 1 : 0) + (y < 0.0 ? 2 : 0)];
        }
        for (const int count : quadrants) ASSERT_EQ(count, ray_count / 4) << "surfel " << i;
    }
}

/// Lines whose far ends lie on one plane are exact, and so are rays: the sites of a surfel.
std::vector<ref::PowerSite> sites_of(const RayScene& s, int i) {
    std::vector<ref::PowerSite> sites;
    const dvec3 x = s.host->position(i), n = s.host->normal(i);
    const int pencils = static_cast<int>(s.centres.size());
    for (const float4& centre : s.centres) {
        const dvec3 c = xyz(centre), direction = glm::normalize(c - x);
        if (glm::dot(direction, n) <= 0.0) continue;
        const ref::RayHit far = s.cast(c, direction);
        const double path = glm::distance(x, c) + far.t;
        sites.push_back({direction, colour_of(s.plane_of(far)),
                         ref::line_and_ray_density(path, glm::dot(direction, n), pencils, test_space().volume, ray_count)});
    }
    for (int k = 0; k < ray_count; ++k) {
        const dvec3 direction = s.ray_direction(i, k);
        const double path = std::min(s.cast(x + 1e-6 * n, direction).t, box_exit(x, direction));
        sites.push_back({direction, s.ray_light(i, k),
                         ref::line_and_ray_density(path, glm::dot(direction, n), pencils, test_space().volume, ray_count)});
    }
    return sites;
}

void check_cells(const RayScene& s) {
    const int grid = cell_grid(static_cast<int>(s.centres.size()) + ray_count);
    const std::vector<float4> table = cell_directions(grid);
    double doubt = 0.0, sum = 0.0;
    int wrong = 0;
    for (int i = 0; i < s.host->count; ++i) {
        const ref::Frame frame(s.host->normal(i));
        const std::vector<ref::PowerSite> sites = sites_of(s, i);
        dvec3 low(0.0), high(0.0);
        for (std::size_t k = table.size() - static_cast<std::size_t>(grid * grid); k < table.size(); ++k) {
            const ref::LightRange light = ref::nearest_light(frame.to_world(xyz(table[k])), sites, ray_count, 2e-4);
            low += light.low / static_cast<double>(grid * grid);
            high += light.high / static_cast<double>(grid * grid);
        }
        const dvec3 got = rgb_at(s.after, s.host->capacity, i) / s.host->albedo(i);
        // A texel in a corner may show two planes of which it holds one.
        wrong += glm::any(glm::lessThan(got, low * 0.999)) || glm::any(glm::greaterThan(got, high * 1.001)) ? 1 : 0;
        doubt += high.x - low.x;
        sum += high.x;
    }
    EXPECT_LE(wrong, s.host->count / 50);
    EXPECT_LE(doubt, 0.02 * sum) << "too many ties to tell right from wrong";
}

TEST(ProjectRays, CellsOfLinesAndRaysAreThoseOfAPowerDiagram) { check_cells(RayScene(box_scene(134), 40, 256, 4)); }

TEST(ProjectRays, CellsOfHundredsOfSitesAreThoseOfAPowerDiagram) { check_cells(RayScene(box_scene(135), 200, 256, 5)); }

TEST(ProjectRays, HowMuchIsDoneAtOnceDoesNotMatter) {
    const RayScene whole(room_scene(136, 12), 24, 500, 6);
    for (const RayStretch& stretch : {RayStretch{surfel_multiple, 1}, RayStretch{2 * surfel_multiple, 3 * surfel_multiple}}) {
        const RayScene parts(room_scene(136, 12), 24, 500, 6, stretch);
        ASSERT_EQ(parts.host->count, whole.host->count);
        EXPECT_GT(parts.host->count, stretch.surfels);
        EXPECT_EQ(parts.after, whole.after) << "bit by bit";
    }
}

TEST(ProjectRays, StretchesKeepTheDeviceBusyAndLaunchesShort) {
    const Kernels kernels(device(), Features());
    for (const int pencils : {1, 128, 4096})
        for (const int side : {1, 8, 24}) {
            const RayStretch stretch = ray_stretch(kernels, {side, 0, 0}, pencils);
            EXPECT_EQ(stretch.surfels % surfel_multiple, 0);
            EXPECT_LE(stretch.surfels, std::max(stretch.launch, surfel_multiple)) << "one ray of each surfel is a launch at most";
            EXPECT_GE(kernels.packets(stretch.surfels), device()->info().compute_units)
                << pencils << " pencils, " << side * side << " rays";
        }
    EXPECT_LE(3 * ray_stretch(kernels, {8, 0, 0}, 4096).launch, ray_stretch(kernels, {8, 0, 0}, 128).launch) << "each ray asks all pencils";
}

}  // namespace
