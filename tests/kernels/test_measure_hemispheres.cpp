// What a pencil knows of the geometry about it, from what its texels see.
#include "kernels/surface_test.h"
#include "reference/hemisphere_ref.h"
#include "reference/tolerances.h"
#include "surface/measure_hemispheres.h"

namespace {

using namespace pencil;
using namespace pencil::test;

struct Hemisphere {
    SurfacePencil pencil;
    std::vector<ref::SeenTexel> seen;
};

/// Texels see points anywhere above the pencil, on few planes, with normals towards it; one in nine sees nothing.
Hemisphere random_hemisphere(Random& random, int n) {
    Hemisphere h{random_pencils(static_cast<std::uint32_t>(random.index(1 << 30)), 1).front(), {}};
    const dvec3 x = xyz(h.pencil.position);
    for (int i = 0; i < n * n; ++i) {
        const dvec3 step = ref::as_float(random.direction() * random.uniform(0.1, 1.5));
        dvec3 g = random.direction();
        if (glm::dot(g, step) > 0) g = -g;
        if (glm::dot(g, step) > -0.01) g = glm::normalize(-step);
        h.seen.push_back({ref::as_float(x + step), ref::as_float(g), random.index(9) == 0 ? -1 : random.index(3)});
    }
    return h;
}

/// Pencils first .. of a set whose texels are surfels first_surfel ..
std::vector<SurfacePencil> measured(const std::vector<Hemisphere>& hemispheres, int n, int first_surfel, int first) {
    const int texels = n * n, count = static_cast<int>(hemispheres.size());
    MadeSurfels surfels(first_surfel + count * texels);
    std::vector<SurfacePencil> pencils(static_cast<std::size_t>(first));
    for (int p = 0; p < count; ++p) {
        const Hemisphere& h = hemispheres[static_cast<std::size_t>(p)];
        pencils.push_back(h.pencil);
        for (int i = 0; i < texels; ++i) {
            const ref::SeenTexel& s = h.seen[static_cast<std::size_t>(i)];
            if (s.plane < 0) continue;
            surfels.place(first_surfel + p * texels + i, s.position, s.normal, s.plane, dvec3(0.5));
        }
    }
    Kernels kernels = make_kernels();
    SurfacePencils set = on_device(pencils, n);
    measure_hemispheres(kernels, surfels.on_device(), first_surfel, first, count, set);
    return set.data.read(0, pencils.size());
}

void expect_measured(const SurfacePencil& got, const Hemisphere& h, int n, const std::string& what) {
    const ref::Measured expected = ref::measure(h.seen, xyz(h.pencil.position), xyz(h.pencil.normal), n);
    EXPECT_NEAR(got.position.w / expected.harmonic, 1.0, tolerance::accumulation) << what;
    for (int s = 0; s < 2 * RING_SECTORS; ++s) {
        const double size = 1.0 + std::hypot(expected.horizon_x[s], expected.horizon_y[s]);
        EXPECT_NEAR(got.horizon_x[s], expected.horizon_x[s], tolerance::quotient * size) << what << ", x of slot " << s;
        EXPECT_NEAR(got.horizon_y[s], expected.horizon_y[s], tolerance::quotient * size) << what << ", y of slot " << s;
    }
    EXPECT_EQ(xyz(got.position), xyz(h.pencil.position)) << what;
    EXPECT_EQ(got.normal, h.pencil.normal) << what;
    EXPECT_EQ(got.key, h.pencil.key) << what;
}

TEST(MeasureHemispheres, AreTheReferences) {
    Random random(21);
    for (const int n : {4, 8, 16})
        for (const int count : {1, 13, 70}) {
            std::vector<Hemisphere> hemispheres;
            for (int p = 0; p < count; ++p) hemispheres.push_back(random_hemisphere(random, n));
            const int first = count % 3;
            const std::vector<SurfacePencil> got = measured(hemispheres, n, 16 * first, first);
            for (int p = 0; p < count; ++p)
                expect_measured(got[static_cast<std::size_t>(first + p)], hemispheres[static_cast<std::size_t>(p)], n,
                                "pencil " + std::to_string(p) + " of " + std::to_string(count) + ", n " + std::to_string(n));
        }
}

/// The harmonic mean distance at the centre of a sphere is its radius.
TEST(MeasureHemispheres, InTheMiddleOfASphereAllIsARadiusAway) {
    Random random(22);
    for (const double radius : {0.01, 0.3, 1.0}) {
        Hemisphere h = random_hemisphere(random, 8);
        h.pencil.position = float4(0);
        for (ref::SeenTexel& s : h.seen) {
            const dvec3 w = random.direction();
            s = {w * radius, -w, 0};
        }
        EXPECT_NEAR(measured({h}, 8, 0, 0).front().position.w / radius, 1.0, tolerance::accumulation) << radius;
    }
}

TEST(MeasureHemispheres, NothingSeenIsInfinitelyFarAndHidesNothing) {
    Random random(23);
    Hemisphere h = random_hemisphere(random, 4);
    for (ref::SeenTexel& s : h.seen) s.plane = -1;
    const SurfacePencil got = measured({h}, 4, 0, 0).front();
    EXPECT_EQ(got.position.w, HUGE_VALF);
    for (int s = 0; s < 2 * RING_SECTORS; ++s) EXPECT_EQ(std::abs(got.horizon_x[s]) + std::abs(got.horizon_y[s]), 0.0F) << "slot " << s;
}

}  // namespace
