// Projection and scattering against thesis eq. (5.23) and alg. 6.3 with both normalisers, from random radiance maps and density weights and
// the kernel's own visibility masks (they have their own test).
#include "kernels/kernel_test.h"
#include "reference/tolerances.h"
#include "reference/transport_ref.h"
#include "transport/project_pencils.h"
#include "transport/store_radiance.h"
#include "transport/test_visibility.h"

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
    Kernels kernels = make_kernels(c.smooth, c.thesis);
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
    project_pencils(kernels, on_device, surfels, set, outgoing, visible, "test");
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

TEST(ProjectPencils, ConstantRadianceGivesAlbedoTimesIt) {
    const TestScene scene = room_scene(107, 10);
    Random random(108);
    Kernels kernels = make_kernels();
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
    project_pencils(kernels, on_device, surfels, set, outgoing, visible, "test");
    const std::vector<float> after = outgoing.read();
    const std::vector<int> counts = visible.read();
    for (int i = 0; i < host.count; ++i) {
        const dvec3 expected = counts[static_cast<std::size_t>(i)] > 0 ? host.albedo(i) * dvec3(2.0, 0.5, 0.0) : dvec3(0.0);
        expect_close(rgb_at(after, host.capacity, i), expected, tolerance::accumulation, "surfel " + std::to_string(i));
    }
}

}  // namespace
