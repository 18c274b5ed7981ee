// Irradiance of the pencils near each surfel, reflected.
#include "kernels/surface_test.h"
#include "reference/surface_transport_ref.h"
#include "reference/tolerances.h"
#include "reference/transport_ref.h"
#include "surface/project_surface_pencils.h"

namespace {

using namespace pencil;
using namespace pencil::test;

constexpr float start_light = 0.5F;  // what the surfels send before

struct ProjectedPencils {
    std::vector<float> outgoing;
    std::vector<unsigned char> contact;
};

/// Viewers have maps of 4 x 4 texels.
ProjectedPencils project(const std::vector<SurfacePencil>& pencils, const std::vector<float4>& irradiance, const MadeSurfels& surfels,
                         const std::vector<SurfacePencil>& viewers, int first_viewer, float nearness) {
    Kernels kernels = make_kernels();
    const SurfacePencils set = on_device(pencils);
    SurfacePencils seeing = on_device(viewers);
    seeing.n = 4;
    Buffer<float> outgoing = filled_rgb(surfels.capacity, start_light);
    Buffer<unsigned char> contact(device(), std::vector<unsigned char>(static_cast<std::size_t>(surfels.capacity), 7), "contacts");
    project_surface_pencils(kernels, far_scene(), surfels.on_device(), set, Buffer<float4>(device(), irradiance, "irradiance"),
                            DeviceGrid(device(), pencils), {seeing, first_viewer}, nearness, outgoing, contact);
    return {outgoing.read(), contact.read()};
}

std::vector<float> project(const std::vector<SurfacePencil>& pencils, const std::vector<float4>& irradiance, const MadeSurfels& surfels) {
    const ProjectedPencils projected = project(pencils, irradiance, surfels, pencils, 0, 0);
    for (int i = 0; i < surfels.count; ++i) EXPECT_EQ(projected.contact[static_cast<std::size_t>(i)], 0) << i;
    return projected.outgoing;
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
                dvec3 expected(start_light);
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

TEST(ProjectSurfacePencils, WhatIsSeenFromNearIsLeftToItself) {
    constexpr int count = 992, first_viewer = 3;
    constexpr float nearness = 0.6F;
    BumpySurface surface(11);
    std::vector<SurfacePencil> placed, viewers;
    for (int p = 0; p < 60; ++p) placed.push_back(surface.pencil(surface.point(), surface.random.uniform(0.05, 0.4)));
    for (int v = 0; v < first_viewer + count / 16; ++v) viewers.push_back(surface.pencil(surface.point(), 0.1));
    const std::vector<float4> irradiance = random_irradiance(surface.random, placed.size());
    const MadeSurfels surfels = made_surfels(surface, count);
    const ProjectedPencils all = project(placed, irradiance, surfels, viewers, first_viewer, 0),
                           far = project(placed, irradiance, surfels, viewers, first_viewer, nearness);
    const auto capacity = static_cast<std::size_t>(surfels.capacity);
    int contacts = 0, others = 0;
    for (int i = 0; i < count; ++i) {
        const std::string what = "surfel " + std::to_string(i);
        const bool reflects = surfels.bits(SURFEL_PLANE, i) >= 0 && surfels.albedo(i) != dvec3(0);
        const ref::FoundLinks found = ref::find_links(placed, surfels.position(i), surfels.normal(i));
        if (reflects && found.margin < tolerance::decision) continue;
        bool contact = reflects && found.links.empty();
        if (reflects && !contact) {
            const double distance =
                             glm::distance(surfels.position(i), xyz(viewers[static_cast<std::size_t>(first_viewer + i / 16)].position)),
                         most = nearness * placed[static_cast<std::size_t>(found.links.front().pencil)].normal.w;
            if (std::abs(distance - most) < tolerance::position) continue;
            contact = distance < most;
        }
        EXPECT_EQ(far.contact[static_cast<std::size_t>(i)], contact ? 1 : 0) << what;
        expect_close(rgb_at(far.outgoing, capacity, i), contact ? dvec3(start_light) : rgb_at(all.outgoing, capacity, i), 0, what);
        ++(contact ? contacts : others);
    }
    EXPECT_GT(contacts, 50);
    EXPECT_GT(others, 500);
}

TEST(ProjectSurfacePencils, ConstantIrradianceStaysConstant) {
    BumpySurface surface(3);
    std::vector<SurfacePencil> placed;
    for (int p = 0; p < 200; ++p) placed.push_back(surface.pencil(surface.point(), 0.3));
    const MadeSurfels surfels = made_surfels(surface, 700);
    const std::vector<float> got = project(placed, std::vector<float4>(200, float4(2, 3, 4, 0)), surfels);
    int lit = 0;
    for (int i = 0; i < 700; ++i) {
        const dvec3 reflected = rgb_at(got, static_cast<std::size_t>(surfels.capacity), i) - dvec3(start_light);
        if (reflected == dvec3(0)) continue;
        ++lit;
        expect_close(reflected, surfels.albedo(i) * dvec3(2, 3, 4) / ref::pi, tolerance::accumulation, "surfel " + std::to_string(i));
    }
    EXPECT_GT(lit, 400);
}

}  // namespace
