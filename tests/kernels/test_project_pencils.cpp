// Projection and scattering against thesis eq. (5.23) and alg. 6.3 with every form of weights, from random radiance maps and density
// weights and the kernel's own visibility masks (they have their own test).
#include "kernels/kernel_test.h"
#include "line/project_pencils.h"
#include "line/store_radiance.h"
#include "line/test_visibility.h"
#include "line/weights.h"
#include "pencils/cell_directions.h"
#include "reference/tolerances.h"
#include "reference/transport_ref.h"
#include "reference/voronoi_ref.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// Gutters repeat the texel they fold to.
std::vector<float4> random_tiles(Random& random, int tiles, int n) {
    std::vector<float4> out(static_cast<std::size_t>(tiles) * static_cast<std::size_t>(PENCIL_TILE_TEXELS(n)));
    for (int tile = 0; tile < tiles; ++tile) {
        for (int pass = 0; pass < 2; ++pass) {
            for (int y = -1; y <= n; ++y) {
                for (int x = -1; x <= n; ++x) {
                    const ref::Texel t = ref::fold(x, y, n);
                    const bool interior = t.x == x && t.y == y;
                    if (pass == 0 && interior)
                        out[atlas_index(tile, x, y, n)] = to_float4(random.in_box(0.0, 3.0), random.uniform(0.05, 1.0));
                    if (pass == 1 && !interior) out[atlas_index(tile, x, y, n)] = out[atlas_index(tile, t.x, t.y, n)];
                }
            }
        }
    }
    return out;
}

struct Case {
    int pencils, n, limit;
    bool thesis, smooth;
};

void check(TestScene scene, const Case& c, std::uint32_t seed) {
    SCOPED_TRACE(std::to_string(c.pencils) + " pencils, n " + std::to_string(c.n) + ", " + std::to_string(c.limit) + " surfels, thesis " +
                 std::to_string(c.thesis));
    Random random(seed);
    if (c.smooth) {
        for (const ref::Triangle& t : scene.triangles) {
            const dvec3 face = glm::normalize(glm::cross(t.v1 - t.v0, t.v2 - t.v0));
            for (int k = 0; k < 3; ++k) scene.flat.normals.push_back(to_float4(glm::normalize(face + 0.8 * random.direction())));
        }
    }
    Kernels kernels = make_kernels(c.smooth, c.thesis ? Weights::thesis : Weights::dpdf);
    const DeviceScene on_device(device(), scene.flat);
    const std::vector<float4> centres = random_centres(random, c.pencils);
    const auto maps = std::make_shared<GeometryMaps>(rasterized(kernels, on_device, centres, c.n));
    PencilSet set(device(), maps);
    const std::vector<float4> tiles = random_tiles(random, c.pencils, c.n);
    set.radiance.write(tiles);
    const Surfels surfels = gathered(kernels, on_device, random_centres(random, 3), 16, c.limit);
    const HostSurfels host(surfels);
    std::vector<float> before(host.capacity * 3);
    for (float& value : before) value = static_cast<float>(random.uniform());
    Buffer<float> outgoing(device(), before, "outgoing");
    Buffer<int> visible(device(), host.capacity, "visible");
    Buffer<uint> mask(device(), static_cast<std::size_t>(mask_words(c.pencils)) * host.capacity, "mask");
    WeightTables tables(kernels);
    project_pencils(kernels, on_device, surfels, set, tables, outgoing, visible, "test");
    test_visibility(kernels, on_device, surfels, *maps, mask);
    const std::vector<float> after = outgoing.read();
    const std::vector<int> counts = visible.read();
    const std::vector<uint> bits = mask.read();
    for (int i = 0; i < host.count; ++i) {
        std::vector<ref::PencilView> views;
        int count = 0;
        for (int p = 0; p < c.pencils; ++p) {
            const dvec3 to_pencil = xyz(centres[static_cast<std::size_t>(p)]) - host.position(i);
            const auto texel = [&](int x, int y) { return glm::dvec4(tiles[atlas_index(p, x, y, c.n)]); };
            const glm::dvec4 map = ref::bilinear(texel, ref::direction_to_oct(-to_pencil), c.n);
            ref::PencilView view;
            view.radiance = dvec3(map);
            view.density = 1.0 / map.w;
            view.cosine = glm::dot(host.normal(i), glm::normalize(to_pencil));
            view.visible = (bits[static_cast<std::size_t>(p / 32) * host.capacity + static_cast<std::size_t>(i)] >> (p % 32) & 1U) != 0U;
            count += view.visible ? 1 : 0;
            views.push_back(view);
        }
        ASSERT_EQ(counts[static_cast<std::size_t>(i)], count) << "pencils seen by surfel " << i;
        const dvec3 e = c.thesis ? ref::irradiance_printed(views) : ref::irradiance_consistent(views);
        const dvec3 expected = rgb_at(before, host.capacity, i) + ref::scattered_radiance(host.albedo(i), e);
        // The place in the map is good to few_operations in direction, n / 2 times that in texels, and neighbouring texels are unrelated.
        const double relative = tolerance::accumulation + 0.5 * c.n * tolerance::few_operations;
        expect_close(rgb_at(after, host.capacity, i), expected, relative, "surfel " + std::to_string(i));
        if (testing::Test::HasFatalFailure()) return;
    }
}

TEST(ProjectPencils, ConsistentWeights) {
    check(box_scene(101), {1, 8, 1, false, false}, 1);
    check(box_scene(101), {33, 16, 37, false, false}, 2);
    check(box_scene(101), {128, 8, 768, false, false}, 3);
    check(room_scene(102, 20), {70, 32, 768, false, false}, 4);
    check(soup_scene(103, 30), {20, 24, 500, false, false}, 5);
    check(room_scene(104, 15), {40, 16, 768, false, true}, 6);
}

TEST(ProjectPencils, PrintedWeights) {
    check(box_scene(105), {1, 8, 5, true, false}, 7);
    check(box_scene(105), {130, 16, 300, true, false}, 8);
    check(room_scene(106, 20), {70, 32, 768, true, false}, 9);
}

/// A scene with pencils of random radiance, projected with Voronoi weights.
struct Projected {
    Projected(const TestScene& scene, std::vector<float4> pencil_centres, std::vector<float4> pencil_tiles, int n, int limit,
              std::uint32_t seed)
        : centres(std::move(pencil_centres)), tiles(std::move(pencil_tiles)) {
        Random random(seed);
        const int count = static_cast<int>(centres.size());
        Kernels kernels = make_kernels(!scene.flat.normals.empty(), Weights::voronoi, largest_cell_grid(count));
        const DeviceScene on_device(device(), scene.flat);
        const auto maps = std::make_shared<GeometryMaps>(rasterized(kernels, on_device, centres, n));
        PencilSet set(device(), maps);
        set.radiance.write(tiles);
        const Surfels surfels = gathered(kernels, on_device, random_centres(random, 3), 16, limit);
        host = std::make_unique<HostSurfels>(surfels);
        Buffer<float> outgoing = surfel_rgb(device(), surfels.capacity, "outgoing");
        Buffer<int> visible(device(), host->capacity, "visible");
        Buffer<uint> mask(device(), static_cast<std::size_t>(mask_words(count)) * host->capacity, "mask");
        WeightTables tables(kernels);
        project_pencils(kernels, on_device, surfels, set, tables, outgoing, visible, "test");
        test_visibility(kernels, on_device, surfels, *maps, mask);
        after = outgoing.read();
        counts = visible.read();
        bits = mask.read();
    }
    bool sees(int surfel, std::size_t pencil) const {
        return (bits[pencil / 32 * host->capacity + static_cast<std::size_t>(surfel)] >> (pencil % 32) & 1U) != 0U;
    }
    dvec3 towards(int surfel, std::size_t pencil) const { return glm::normalize(xyz(centres[pencil]) - host->position(surfel)); }

    std::vector<float4> centres, tiles;
    std::unique_ptr<HostSurfels> host;
    std::vector<float> after;
    std::vector<int> counts;
    std::vector<uint> bits;
};

/// Every sample direction of every surfel against the brute-force nearest pencil. Where several are equally near to rounding (of the
/// kernel's distances, with the number of the pencil in the lowest bits), any of them may have been taken.
void check_cells(const TestScene& scene, int pencils, int n, int limit, std::uint32_t seed) {
    SCOPED_TRACE(std::to_string(pencils) + " pencils, " + std::to_string(limit) + " surfels");
    Random random(seed);
    const std::vector<float4> centres = random_centres(random, pencils);
    const Projected p(scene, centres, random_tiles(random, pencils, n), n, limit, seed + 1);
    const int grid = cell_grid(pencils);
    const std::vector<float4> table = cell_directions(grid);
    double doubt = 0.0, sum = 0.0;
    for (int i = 0; i < p.host->count; ++i) {
        const ref::Frame frame(p.host->normal(i));
        std::vector<dvec3> directions, radiance;
        std::vector<bool> visible;
        for (std::size_t k = 0; k < centres.size(); ++k) {
            directions.push_back(p.towards(i, k));
            visible.push_back(p.sees(i, k));
            const auto texel = [&](int x, int y) { return glm::dvec4(p.tiles[atlas_index(static_cast<int>(k), x, y, n)]); };
            radiance.emplace_back(ref::bilinear(texel, ref::direction_to_oct(-directions.back()), n));
        }
        ASSERT_EQ(p.counts[static_cast<std::size_t>(i)], std::count(visible.begin(), visible.end(), true)) << "surfel " << i;
        dvec3 low(0.0), high(0.0);
        for (std::size_t k = table.size() - static_cast<std::size_t>(grid * grid); k < table.size(); ++k) {
            const dvec3 sample = frame.to_world(xyz(table[k]));
            const auto nearest = ref::nearest_directions(sample, directions, visible, std::ldexp(pencils, -22), 2e-6);
            if (nearest.empty()) continue;
            dvec3 least(1e9), most(0.0);
            for (const std::size_t pencil : nearest) {
                least = glm::min(least, radiance[pencil]);
                most = glm::max(most, radiance[pencil]);
            }
            low += least / static_cast<double>(grid * grid);
            high += most / static_cast<double>(grid * grid);
        }
        const dvec3 got = rgb_at(p.after, p.host->capacity, i);
        for (int c = 0; c < 3; ++c) {
            const double slack = (tolerance::accumulation + 0.5 * n * tolerance::few_operations) * (high[c] + 1e-3);
            ASSERT_GE(got[c], p.host->albedo(i)[c] * (low[c] - slack)) << "surfel " << i << " component " << c;
            ASSERT_LE(got[c], p.host->albedo(i)[c] * (high[c] + slack)) << "surfel " << i << " component " << c;
            doubt += high[c] - low[c];
            sum += high[c];
        }
    }
    EXPECT_LE(doubt, 0.01 * sum) << "too many ties to tell right from wrong";
}

TEST(ProjectPencils, VoronoiWeights) {
    check_cells(box_scene(111), 1, 8, 1, 11);
    check_cells(box_scene(111), 33, 16, 37, 12);
    check_cells(box_scene(111), 127, 8, 200, 13);
    check_cells(box_scene(111), 128, 8, 200, 13);
    check_cells(room_scene(112, 20), 300, 16, 150, 14);
    check_cells(soup_scene(113, 30), 20, 24, 500, 15);
    check_cells(box_scene(114), 4200, 8, 5, 16);
    TestScene smooth = room_scene(115, 15);
    Random random(116);
    for (const ref::Triangle& t : smooth.triangles) {
        const dvec3 face = glm::normalize(glm::cross(t.v1 - t.v0, t.v2 - t.v0));
        for (int k = 0; k < 3; ++k) smooth.flat.normals.push_back(to_float4(glm::normalize(face + 0.8 * random.direction())));
    }
    check_cells(smooth, 40, 16, 200, 17);
}

TEST(ProjectPencils, VoronoiCellsOfTwoPencilsAreHalvesByTheirBisector) {
    Random random(118);
    std::vector<float4> tiles = random_tiles(random, 2, 16);
    for (std::size_t i = 0; i < tiles.size(); ++i) tiles[i] = i < tiles.size() / 2 ? float4(1, 0, 0, 0) : float4(0, 1, 0, 0);
    const Projected p(box_scene(117), random_centres(random, 2, 0.5), tiles, 16, 768, 119);
    double error = 0.0;
    int both = 0;
    for (int i = 0; i < p.host->count; ++i) {
        const dvec3 shares = rgb_at(p.after, p.host->capacity, i) / p.host->albedo(i);
        ASSERT_NEAR(shares.x + shares.y, p.counts[static_cast<std::size_t>(i)] > 0 ? 1.0 : 0.0, tolerance::accumulation) << i;
        if (!p.sees(i, 0) || !p.sees(i, 1)) continue;
        const double half = ref::first_of_two(p.host->normal(i), p.towards(i, 0), p.towards(i, 1)) / ref::pi;
        ASSERT_NEAR(shares.x, half, 0.08) << "surfel " << i << ": 64 directions, of which at most some 10 lie at the bisector";
        error += shares.x - half;
        ++both;
    }
    ASSERT_GT(both, 500);
    EXPECT_NEAR(error / both, 0.0, 0.005);
}

TEST(ProjectPencils, OrderOfPencilsDoesNotMatter) {
    const TestScene scene = room_scene(120, 20);
    constexpr int pencils = 100, n = 16;
    Random random(121);
    const std::vector<float4> centres = random_centres(random, pencils), tiles = random_tiles(random, pencils, n);
    const std::vector<float4> reversed(centres.rbegin(), centres.rend());
    std::vector<float4> reversed_tiles;
    const auto texels = static_cast<std::ptrdiff_t>(PENCIL_TILE_TEXELS(n));
    for (int tile = pencils - 1; tile >= 0; --tile)
        reversed_tiles.insert(reversed_tiles.end(), tiles.begin() + tile * texels, tiles.begin() + (tile + 1) * texels);
    const Projected a(scene, centres, tiles, n, 768, 122), b(scene, reversed, reversed_tiles, n, 768, 122);
    int changed = 0;
    for (int i = 0; i < a.host->count; ++i) {
        const dvec3 x = rgb_at(a.after, a.host->capacity, i), y = rgb_at(b.after, b.host->capacity, i);
        ASSERT_EQ(a.counts[static_cast<std::size_t>(i)], b.counts[static_cast<std::size_t>(i)]);
        ASSERT_LE(glm::length(x - y), 0.02) << "surfel " << i << ": a direction between two cells may change hands";
        changed += glm::length(x - y) > tolerance::accumulation * (1.0 + glm::length(x)) ? 1 : 0;
    }
    EXPECT_LE(changed, 8) << "of 768 surfels";
}

void check_constant(Weights weights) {
    SCOPED_TRACE(kernel_weights(weights));
    const TestScene scene = room_scene(107, 10);
    Random random(108);
    Kernels kernels = make_kernels(false, weights, weights == Weights::voronoi ? largest_cell_grid(50) : 0);
    const DeviceScene on_device(device(), scene.flat);
    const auto maps = std::make_shared<GeometryMaps>(rasterized(kernels, on_device, random_centres(random, 50), 16));
    PencilSet set(device(), maps);
    std::vector<float4> tiles = random_tiles(random, 50, 16);
    for (float4& texel : tiles) texel = float4(2.0F, 0.5F, 0.0F, texel.w);
    set.radiance.write(tiles);
    const Surfels surfels = gathered(kernels, on_device, random_centres(random, 2), 16, 512);
    const HostSurfels host(surfels);
    Buffer<float> outgoing = surfel_rgb(device(), surfels.capacity, "outgoing");
    Buffer<int> visible(device(), host.capacity, "visible");
    WeightTables tables(kernels);
    project_pencils(kernels, on_device, surfels, set, tables, outgoing, visible, "test");
    const std::vector<float> after = outgoing.read();
    const std::vector<int> counts = visible.read();
    for (int i = 0; i < host.count; ++i) {
        const dvec3 expected = counts[static_cast<std::size_t>(i)] > 0 ? host.albedo(i) * dvec3(2.0, 0.5, 0.0) : dvec3(0.0);
        expect_close(rgb_at(after, host.capacity, i), expected, tolerance::accumulation, "surfel " + std::to_string(i));
    }
}

TEST(ProjectPencils, ConstantRadianceGivesAlbedoTimesIt) {
    for (const Weights weights : {Weights::dpdf, Weights::voronoi, Weights::analytic}) check_constant(weights);
}

}  // namespace
