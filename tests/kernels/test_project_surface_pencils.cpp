// Irradiance of the pencils near each surfel, reflected.
#include "kernels/surface_test.h"
#include "reference/surface_transport_ref.h"
#include "reference/tolerances.h"
#include "reference/transport_ref.h"
#include "surface/project_surface_pencils.h"

namespace {

using namespace pencil;
using namespace pencil::test;

constexpr float start = 0.5F;  // what the surfels send before

std::vector<float> project(const std::vector<SurfacePencil>& pencils, const std::vector<float4>& irradiance, const MadeSurfels& surfels) {
    Kernels kernels = make_kernels();
    SurfacePencils set = on_device(pencils);
    set.irradiance.write(irradiance);
    Buffer<float> outgoing = filled_rgb(surfels.capacity, start);
    project_surface_pencils(kernels, surfels.on_device(), set, DeviceGrid(device(), pencils), outgoing);
    return outgoing.read();
}

/// Every seventh surfel is black, every eleventh saw nothing.
MadeSurfels made_surfels(BumpySurface& surface, int count) {
    MadeSurfels surfels(count);
    for (int i = 0; i < count; ++i)
        surfels.place(i, surface.point(), surface.normal(), i % 11 == 10 ? -1 : i % 5, i % 7 == 6 ? dvec3(0) : surface.random.in_box(0, 1));
    return surfels;
}

TEST(ProjectSurfacePencils, ReflectTheLinkedIrradiance) {
    int compared = 0;
    for (const int pencils : {1, 37, 300})
        for (const int count : {1, 37, 1000}) {
            BumpySurface surface(static_cast<std::uint32_t>(pencils * count));
            std::vector<SurfacePencil> placed;
            for (int p = 0; p < pencils; ++p) placed.push_back(surface.pencil(surface.point(), surface.random.uniform(0.05, 0.4)));
            const std::vector<float4> irradiance = random_irradiance(surface.random, placed.size());
            const MadeSurfels surfels = made_surfels(surface, count);
            const std::vector<float> got = project(placed, irradiance, surfels);
            for (int i = 0; i < surfels.capacity; ++i) {
                dvec3 expected(start);
                if (i < count && surfels.bits(SURFEL_PLANE, i) >= 0) {
                    const ref::FoundLinks found = ref::find_links(placed, surfels.position(i), surfels.normal(i));
                    if (found.margin < tolerance::decision || found.links.empty()) continue;  // stand-ins: test_link_surfels.cpp
                    expected += ref::scattered_radiance(surfels.albedo(i), ref::linked_irradiance(found.links, irradiance));
                    ++compared;
                }
                expect_close(rgb_at(got, static_cast<std::size_t>(surfels.capacity), i), expected, tolerance::accumulation,
                             "surfel " + std::to_string(i) + " of " + std::to_string(count));
            }
        }
    EXPECT_GT(compared, 1500);
}

TEST(ProjectSurfacePencils, ConstantIrradianceStaysConstant) {
    BumpySurface surface(3);
    std::vector<SurfacePencil> placed;
    for (int p = 0; p < 200; ++p) placed.push_back(surface.pencil(surface.point(), 0.3));
    const MadeSurfels surfels = made_surfels(surface, 700);
    const std::vector<float> got = project(placed, std::vector<float4>(200, float4(2, 3, 4, 0)), surfels);
    int lit = 0;
    for (int i = 0; i < 700; ++i) {
        const dvec3 reflected = rgb_at(got, static_cast<std::size_t>(surfels.capacity), i) - dvec3(start);
        if (reflected == dvec3(0)) continue;
        ++lit;
        expect_close(reflected, surfels.albedo(i) * dvec3(2, 3, 4) / ref::pi, tolerance::accumulation, "surfel " + std::to_string(i));
    }
    EXPECT_GT(lit, 400);
}

}  // namespace
