// The pencils that light a surfel: those of the grid against all pencils, one by one.
#include "kernels/surface_test.h"
#include "reference/surface_transport_ref.h"
#include "reference/tolerances.h"
#include "surface/link_surfels.h"

namespace {

using namespace pencil;
using namespace pencil::test;

struct Floor {
    std::vector<SurfacePencil> pencils;
    MadeSurfels surfels;
};

/// Pencils and surfels on a bumpy floor; one surfel in eleven saw nothing, one in 101 reflects nothing.
Floor bumpy_floor(int pencils, int surfels, std::uint32_t seed) {
    BumpySurface surface(seed);
    Floor f{{}, MadeSurfels(surfels)};
    for (int p = 0; p < pencils; ++p) f.pencils.push_back(surface.pencil(surface.point(), surface.random.uniform(0.05, 0.4)));
    for (int i = 0; i < surfels; ++i)
        f.surfels.place(i, surface.point(), surface.normal(), i % 11 == 10 ? -1 : i % 5,
                        i % 101 == 100 ? ref::dvec3(0) : surface.random.in_box(0, 1));
    return f;
}

struct HostLinks {
    std::vector<glm::ivec4> pencils;
    std::vector<float4> weights;
};

HostLinks link(const Floor& f) {
    Kernels kernels = make_kernels();
    const SurfaceLinks links =
        link_surfels(kernels, far_scene(), f.surfels.on_device(), on_device(f.pencils), DeviceGrid(device(), f.pencils));
    return {links.pencils.read(), links.weights.read()};
}

/// A pencil stands in for the surfel if any may: one that may, and none within whose radius the surfel lies is nearer. True if one was
/// compared.
bool expect_stand_in(const Floor& f, int surfel, const glm::ivec4& pencil, const float4& weight, const std::string& what) {
    const ref::dvec3 x = f.surfels.position(surfel), n = f.surfels.normal(surfel);
    double margin = 1.0, nearest = ref::infinite;
    bool any = false;
    for (const SurfacePencil& p : f.pencils) {
        const double distance = glm::distance(x, ref::xyz(p.position));
        if (!ref::may_stand_in(p, x, n, margin)) continue;
        any = true;
        if (distance < static_cast<double>(p.normal.w)) nearest = std::min(nearest, distance);
    }
    if (margin < tolerance::decision) return false;
    EXPECT_EQ(pencil.x >= 0, any) << what;
    if (!any || pencil.x < 0) return false;
    EXPECT_EQ(pencil, glm::ivec4(pencil.x, LINK_STANDS_IN, -1, -1)) << what;
    EXPECT_EQ(weight, float4(1, 0, 0, 0)) << what;
    const SurfacePencil& found = f.pencils.at(static_cast<std::size_t>(pencil.x));
    EXPECT_TRUE(ref::may_stand_in(found, x, n, margin)) << what;
    EXPECT_LE(glm::distance(x, ref::xyz(found.position)), nearest * (1.0 + tolerance::accumulation)) << what;
    return true;
}

TEST(LinkSurfels, AreThoseOfAllPencils) {
    int compared = 0, stood_in = 0, full = 0;
    for (const int pencils : {1, 37, 400})
        for (const int surfels : {1, 37, 1500}) {
            const Floor f = bumpy_floor(pencils, surfels, static_cast<std::uint32_t>(pencils + surfels));
            const HostLinks got = link(f);
            for (int i = 0; i < surfels; ++i) {
                const std::string what =
                    "surfel " + std::to_string(i) + " of " + std::to_string(surfels) + ", " + std::to_string(pencils) + " pencils";
                const glm::ivec4& pencil = got.pencils[static_cast<std::size_t>(i)];
                const float4& weight = got.weights[static_cast<std::size_t>(i)];
                if (f.surfels.bits(SURFEL_PLANE, i) < 0 || f.surfels.albedo(i) == ref::dvec3(0)) {
                    ASSERT_EQ(pencil, glm::ivec4(-1)) << what << " saw nothing, or reflects nothing";
                    continue;
                }
                const ref::FoundLinks expected = ref::find_links(f.pencils, f.surfels.position(i), f.surfels.normal(i));
                if (expected.margin < tolerance::decision) continue;
                ++compared;
                full += expected.links.size() == 4 ? 1 : 0;
                if (expected.links.empty()) {
                    stood_in += expect_stand_in(f, i, pencil, weight, what) ? 1 : 0;
                    continue;
                }
                for (int k = 0; k < 4; ++k) {
                    const bool there = static_cast<std::size_t>(k) < expected.links.size();
                    const ref::Link& link = there ? expected.links[static_cast<std::size_t>(k)] : ref::Link{-1, 0.0};
                    ASSERT_EQ(pencil[k], there ? link.pencil : -1) << what << ", link " << k;
                    ASSERT_NEAR(weight[k], link.weight, tolerance::accumulation) << what << ", link " << k;
                }
            }
        }
    EXPECT_GT(compared, 4000);
    EXPECT_GT(full, 1000) << "surfels with four pencils";
    EXPECT_GT(stood_in, 50);
}

TEST(LinkSurfels, WeightsSumToOne) {
    const HostLinks got = link(bumpy_floor(400, 1500, 3));
    int linked = 0;
    for (std::size_t i = 0; i < got.pencils.size(); ++i) {
        const float4& w = got.weights[i];
        if (got.pencils[i].x < 0) {
            EXPECT_EQ(w, float4(0)) << "surfel " << i;
            continue;
        }
        ++linked;
        EXPECT_NEAR(w.x + w.y + w.z + w.w, 1.0, tolerance::few_operations) << "surfel " << i;
    }
    EXPECT_GT(linked, 1000);
}

TEST(LinkSurfels, PermutingPencilsChangesNothing) {
    const Floor f = bumpy_floor(150, 700, 5);
    Floor turned = f;
    Random random(6);
    const std::vector<int> order = shuffled(random, f.pencils.size());
    for (std::size_t p = 0; p < order.size(); ++p) turned.pencils[p] = f.pencils[static_cast<std::size_t>(order[p])];
    const HostLinks straight = link(f), permuted = link(turned);
    for (std::size_t i = 0; i < straight.pencils.size(); ++i)
        for (int k = 0; k < 4; ++k) {
            const int p = permuted.pencils[i][k];
            EXPECT_EQ(p < 0 ? p : order[static_cast<std::size_t>(p)], straight.pencils[i][k]) << "surfel " << i << ", link " << k;
            EXPECT_EQ(permuted.weights[i][k], straight.weights[i][k]) << "surfel " << i << ", link " << k;
        }
}

/// Pencils inside and outside a closed box that face the same way, a point inside that none reaches.
TEST(LinkSurfels, NothingStandsInFromBehindAWall) {
    const TestScene box = make_scene(box_triangles(0.4), 1, 1);
    const DeviceScene scene(device(), box.flat, build_bvh(box.flat.triangles));
    Kernels kernels = make_kernels();
    MadeSurfels surfels(1);
    surfels.place(0, {-0.4, 0.05, 0.1}, {1, 0, 0}, 0, dvec3(0.5));
    const auto pencil_at = [](const dvec3& x, const dvec3& n, int plane) {
        SurfacePencil p{};
        p.position = to_float4(x, 1);
        p.normal = to_float4(n, 0.01);
        p.facing = p.normal;
        p.plane = plane;
        return p;
    };
    // Behind the wall opposite, beside the box, on a wall further away and on the outside of its own wall, whose plane no ray meets.
    std::vector<SurfacePencil> pencils{pencil_at({0.4, 0.05, 0.1}, {1, 0, 0}, 1), pencil_at({-0.4, 0.05, 0.6}, {1, 0, 0}, -1),
                                       pencil_at({-0.7, 0, 0}, {1, 0, 0}, -1), pencil_at({-0.4, 0.06, 0.1}, {-1, 0, 0}, 0)};
    const auto linked = [&] {
        return link_surfels(kernels, scene, surfels.on_device(), on_device(pencils), DeviceGrid(device(), pencils)).pencils.read().front();
    };
    EXPECT_EQ(linked(), glm::ivec4(-1));
    pencils.push_back(pencil_at({-0.4, -0.3, -0.3}, {1, 0, 0}, 0));  // further away than most, but inside
    EXPECT_EQ(linked(), glm::ivec4(4, LINK_STANDS_IN, -1, -1));
}

}  // namespace
