// 1/D of every texel against thesis eq. (5.32) with the kernel's own visibility masks (they have their own test).
#include "kernels/kernel_test.h"
#include "line/estimate_density.h"
#include "line/test_visibility.h"
#include "reference/density_ref.h"
#include "reference/tolerances.h"

namespace {

using namespace pencil;
using namespace pencil::test;

void check(const TestScene& scene, int pencils, int n, int first, int tiles, std::uint32_t seed) {
    SCOPED_TRACE(std::to_string(pencils) + " pencils, n " + std::to_string(n));
    Random random(seed);
    const std::vector<float4> centres = random_centres(random, pencils);
    Kernels kernels = make_kernels();
    const DeviceScene on_device(device(), scene.flat);
    const auto maps = std::make_shared<GeometryMaps>(rasterized(kernels, on_device, centres, n));
    PencilSet set(device(), maps);
    const float4 untouched(1.0F, 2.0F, 3.0F, -9.0F);
    set.radiance.write(std::vector<float4>(set.radiance.size(), untouched));
    Surfels surfels(device(), tiles * n * n, "surfels");
    gather_surfels(kernels, on_device, *maps, first, tiles, surfels);
    Buffer<uint> mask(device(), static_cast<std::size_t>(mask_words(pencils)) * static_cast<std::size_t>(surfels.capacity), "mask");
    test_visibility(kernels, on_device, surfels, *maps, mask);
    estimate_density(kernels, surfels, mask, first, set);
    const HostSurfels host(surfels);
    const std::vector<uint> bits = mask.read();
    const std::vector<float4> radiance = set.radiance.read();
    for (int i = 0; i < host.count; ++i) {
        const int p = first + i / (n * n);
        const ref::Texel t = surfel_texel(i % (n * n), n);
        const float4 texel = radiance[atlas_index(p, t.x, t.y, n)];
        ASSERT_EQ(xyz(texel), xyz(untouched)) << "radiance of texel " << i << " changed";
        ASSERT_TRUE(texel.w > 0.0F && texel.w <= 1.0F) << "texel " << i << ": " << texel.w;
        if (host.plane(i) < 0) continue;
        std::vector<dvec3> directions;
        std::vector<bool> visible;
        int count = 0;
        for (int j = 0; j < pencils; ++j) {
            directions.push_back(glm::normalize(xyz(centres[static_cast<std::size_t>(j)]) - host.position(i)));
            visible.push_back((bits[static_cast<std::size_t>(j / 32) * host.capacity + static_cast<std::size_t>(i)] >> (j % 32) & 1U) !=
                              0U);
            count += visible.back() ? 1 : 0;
        }
        if (!visible[static_cast<std::size_t>(p)]) continue;  // a grazing texel; it then counts itself all the same
        const double d = ref::pencil_density(directions, visible, ref::lobe_exponent(count))[static_cast<std::size_t>(p)];
        ASSERT_NEAR(texel.w * d, 1.0, tolerance::power_512)
            << "texel " << i << " of pencil " << p << ", " << count << " visible: D " << 1.0 / texel.w << " instead of " << d;
    }
    for (int tile = 0; tile < pencils; ++tile) {
        if (tile >= first && tile < first + tiles) continue;
        ASSERT_EQ(radiance[atlas_index(tile, 0, 0, n)], untouched) << "tile " << tile << " is outside the range";
    }
}

TEST(EstimateDensity, BoxAndRoom) {
    for (const int pencils : {1, 2, 33, 130}) check(box_scene(71), pencils, 16, 0, std::min(pencils, 3), 72);
    check(room_scene(73, 20), 40, 16, 5, 7, 74);
    check(room_scene(75, 20), 700, 8, 690, 10, 76);
    check(soup_scene(77, 30), 20, 8, 0, 20, 78);
}

}  // namespace
