// Light and weights of coarse maps in finer ones: bilinear means, surface by surface.
#include "kernels/surface_test.h"
#include "line/expand_maps.h"
#include "visibility/geometry_maps.h"

namespace {

using namespace pencil;
using namespace pencil::test;

PencilSet random_set(Kernels& kernels, const DeviceScene& scene, const std::vector<float4>& centres, int n, Random& random) {
    auto maps = std::make_shared<GeometryMaps>(device(), centres, n, "test");
    make_geometry_maps(kernels, scene, *maps, 0, maps->count);
    PencilSet set(device(), maps);
    std::vector<float4> radiance(set.radiance.size());
    for (float4& texel : radiance) texel = to_float4(random.in_box(0, 1), random.uniform());
    set.radiance.write(radiance);
    return set;
}

/// What a set shows, on the host.
struct Shown {
    Shown(const PencilSet& set, const TestScene& test_scene)
        : n(set.maps->n), scene(test_scene), hits(set.maps->hits.read()), radiance(set.radiance.read()) {}
    /// Plane behind the texel that light comes through, or before the texel that weights are of.
    int plane(int tile, ref::Texel t, bool light) const {
        if (light) t = ref::antipodal_texel(t.x, t.y, n);
        const int triangle = hits[atlas_index(tile, t.x, t.y, n)].triangle;
        return triangle < 0 ? -1 : scene.flat.triangles[static_cast<std::size_t>(triangle)].plane;
    }
    int n;
    const TestScene& scene;
    std::vector<Hit> hits;
    std::vector<float4> radiance;
};

glm::dvec4 expected(const Shown& coarse, int tile, const dvec3& direction, int plane, bool light) {
    const int m = coarse.n;
    const dvec2 at = (ref::direction_to_oct(direction) + 1.0) * 0.5 * static_cast<double>(m) - 0.5;
    const dvec2 corner = glm::floor(at), f = at - corner;
    glm::dvec4 same(0.0), all(0.0);
    double alike = 0;
    for (int k = 0; k < 4; ++k) {
        const ref::Texel t = ref::fold(static_cast<int>(corner.x) + k % 2, static_cast<int>(corner.y) + k / 2, m);
        const double weight = (k % 2 == 1 ? f.x : 1 - f.x) * (k / 2 == 1 ? f.y : 1 - f.y);
        const glm::dvec4 value(coarse.radiance[atlas_index(tile, t.x, t.y, m)]);
        all += weight * value;
        if (coarse.plane(tile, t, light) != plane) continue;
        same += weight * value;
        alike += weight;
    }
    return alike < 0.02 ? all : same / alike;
}

TEST(ExpandMaps, AreBilinearMeansOfTheSameSurface) {
    Kernels kernels = make_kernels();
    Random random(5);
    for (const int things : {0, 12})
        for (const auto& [m, n] : {std::pair(8, 8), std::pair(8, 16), std::pair(16, 24), std::pair(8, 64)})
            for (const bool light : {true, false}) {
                const TestScene scene = room_scene(static_cast<std::uint32_t>(things) + 3, things);
                const DeviceScene on_device(device(), scene.flat, build_bvh(scene.flat.triangles));
                const std::vector<float4> centres = random_centres(random, 3);
                const PencilSet coarse_set = random_set(kernels, on_device, centres, m, random);
                PencilSet set = random_set(kernels, on_device, centres, n, random);
                const Shown coarse(coarse_set, scene), before(set, scene);
                expand_maps(kernels, on_device, coarse_set, light ? MapPart::light : MapPart::weights, set);
                const std::vector<float4> after = set.radiance.read();
                int unlike = 0, texels = 0;
                for (int tile = 0; tile < 3; ++tile)
                    for (int y = -1; y <= n; ++y)
                        for (int x = -1; x <= n; ++x, ++texels) {
                            const ref::Texel t = ref::fold(x, y, n);
                            const glm::dvec4 value =
                                expected(coarse, tile, ref::texel_direction(t.x, t.y, n), before.plane(tile, t, light), light);
                            const float4 got = after[atlas_index(tile, x, y, n)], was = before.radiance[atlas_index(tile, x, y, n)],
                                         folded = before.radiance[atlas_index(tile, t.x, t.y, n)];
                            if (light)
                                ASSERT_EQ(got.w, folded.w) << "weights stay, gutters repeat them";
                            else
                                ASSERT_EQ(xyz(got), xyz(was)) << "light stays";
                            const double error =
                                light ? glm::distance(xyz(got), dvec3(value)) : std::abs(static_cast<double>(got.w) - value.w);
                            unlike += error > 1e-4 ? 1 : 0;
                        }
                EXPECT_LE(unlike, texels / 500) << m << " to " << n << ": texels on the border of footprints may round to others";
            }
}

}  // namespace
