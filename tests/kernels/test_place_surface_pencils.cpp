// Pencils are put on surfels: what they take from them, and which way they are moved.
#include "kernels/surface_test.h"
#include "reference/tolerances.h"
#include "surface/place_surface_pencils.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// A pencil lies nearer to its viewer by a hundredth of the distance, but at most 3e-5 of the largest coordinate.
dvec3 placed_at(const dvec3& x, const dvec3& viewer) {
    const double distance = glm::distance(x, viewer);
    return distance > 0.0 ? x + (viewer - x) / distance * std::min(0.01 * distance, 30.0 * ref::no_step(x)) : x;
}

struct Placed {
    MadeSurfels surfels;
    ChosenSurfels chosen;
    std::vector<SurfacePencil> pencils;
};

/// `count` pencils behind `before` others, on surfels that are chosen in no order, some more than once.
Placed place(int count, int before, int spacing) {
    Random random(static_cast<std::uint32_t>(count + 7));
    Placed p{MadeSurfels(2 * count), {}, {}};
    for (int i = 0; i < p.surfels.count; ++i) p.surfels.place(i, random.in_box(-1, 1), random.direction(), i % 17, random.in_box(0, 1));
    for (int i = 0; i < p.surfels.count; ++i) p.surfels.set_vector(SURFEL_GX, i, random.direction());
    for (int k = 0; k < count; ++k) {
        const int surfel = random.index(2 * count);
        const dvec3 away = random.direction() * std::pow(10.0, random.uniform(-4, 0));
        p.chosen.add(surfel, static_cast<uint>(k * 31), glm::vec3(p.surfels.position(surfel) + away), static_cast<float>(random.uniform()));
    }
    Kernels kernels = make_kernels();
    SurfacePencils set = on_device(random_pencils(3, before));
    place_surface_pencils(kernels, p.surfels.on_device(), p.chosen, set, spacing);
    EXPECT_EQ(set.count, before + count);
    EXPECT_GE(set.irradiance.size(), static_cast<std::size_t>(set.count)) << "irradiance grows with the pencils";
    p.pencils = set.data.read(0, static_cast<std::size_t>(set.count));
    return p;
}

TEST(PlaceSurfacePencils, TakeWhatTheSurfelsHave) {
    for (const int count : {1, 37, 200}) {
        const Placed p = place(count, 0, 8);
        for (int k = 0; k < count; ++k) {
            const auto at = static_cast<std::size_t>(k);
            const SurfacePencil& pencil = p.pencils[at];
            const int surfel = p.chosen.surfels[at];
            const std::string what = "pencil " + std::to_string(k) + " of " + std::to_string(count);
            const dvec3 x = p.surfels.position(surfel), expected = placed_at(x, xyz(p.chosen.views[at]));
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(pencil.position[c], expected[c], tolerance::position) << what;
            EXPECT_EQ(pencil.position.w, 0.0F) << what << " is not measured yet";
            EXPECT_EQ(xyz(pencil.normal), p.surfels.normal(surfel)) << what;
            EXPECT_EQ(pencil.normal.w, p.chosen.views[at].w) << what;
            EXPECT_EQ(xyz(pencil.facing), p.surfels.vector(SURFEL_GX, surfel)) << what;
            EXPECT_EQ(pencil.plane, p.surfels.bits(SURFEL_PLANE, surfel)) << what;
            EXPECT_EQ(pencil.key, p.chosen.keys[at]) << what;
            EXPECT_EQ(pencil.spacing, 8) << what;
            for (int s = 0; s < 2 * RING_SECTORS; ++s) EXPECT_EQ(std::abs(pencil.horizon_x[s]) + std::abs(pencil.horizon_y[s]), 0) << what;
        }
    }
}

TEST(PlaceSurfacePencils, LieNearerToTheirViewers) {
    const Placed p = place(200, 0, 0);
    for (std::size_t k = 0; k < p.pencils.size(); ++k) {
        const dvec3 x = p.surfels.position(p.chosen.surfels[k]), viewer = xyz(p.chosen.views[k]), at = xyz(p.pencils[k].position);
        EXPECT_LT(glm::distance(at, viewer), glm::distance(x, viewer)) << "pencil " << k;
        EXPECT_GT(glm::distance(at, x), 0.0) << "pencil " << k;
    }
}

TEST(PlaceSurfacePencils, FollowThosePresent) {
    const std::vector<SurfacePencil> present = random_pencils(3, 5), all = place(37, 5, 0).pencils, alone = place(37, 0, 0).pencils;
    ASSERT_EQ(all.size(), 42U);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(std::memcmp(&all[i], &present[i], sizeof all[i]), 0) << "pencil " << i << " was changed";
    for (std::size_t i = 0; i < 37; ++i)
        EXPECT_EQ(std::memcmp(&all[5 + i], &alone[i], sizeof alone[i]), 0) << "pencil " << i << " depends on its place in the list";
}

TEST(PlaceSurfacePencils, NothingChosenIsNothingPlaced) {
    Kernels kernels = make_kernels();
    SurfacePencils set = on_device(random_pencils(3, 2));
    place_surface_pencils(kernels, MadeSurfels(1).on_device(), {}, set);
    EXPECT_EQ(set.count, 2);
}

}  // namespace
