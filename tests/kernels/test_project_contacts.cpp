// What pencils at contacts received, reflected by the texels that they stand for.
#include "kernels/surface_test.h"
#include "reference/tolerances.h"
#include "reference/transport_ref.h"
#include "surface/project_contacts.h"

namespace {

using namespace pencil;
using namespace pencil::test;

TEST(ProjectContacts, ReflectAsOftenAsTheyStandForOthers) {
    constexpr float start = 0.25F;
    for (const int count : {1, 37, 1000}) {
        Random random(static_cast<std::uint32_t>(count));
        MadeSurfels surfels(3 * count);
        for (int i = 0; i < surfels.count; ++i)
            surfels.place(i, random.in_box(-1, 1), random.direction(), i % 5, i % 7 == 6 ? dvec3(0) : random.in_box(0, 1));
        Contacts contacts;
        for (int k = 0; k < count; ++k) {
            contacts.chosen.add(3 * k + random.index(3), static_cast<uint>(k), glm::vec3(0));
            contacts.counts.push_back(static_cast<float>(1 + random.index(16)));
        }
        Kernels kernels = make_kernels();
        SurfacePencils pencils = on_device(random_pencils(5, count));
        const std::vector<float4> irradiance = random_irradiance(random, static_cast<std::size_t>(count));
        pencils.irradiance.write(irradiance);
        Buffer<float> outgoing = filled_rgb(surfels.capacity, start);
        project_contacts(kernels, surfels.on_device(), contacts, pencils, outgoing);

        std::vector<dvec3> expected(static_cast<std::size_t>(surfels.capacity), dvec3(start));
        for (std::size_t k = 0; k < contacts.counts.size(); ++k) {
            const int i = contacts.chosen.surfels[k];
            expected[static_cast<std::size_t>(i)] +=
                static_cast<double>(contacts.counts[k]) * ref::scattered_radiance(surfels.albedo(i), xyz(irradiance[k]));
        }
        const std::vector<float> got = outgoing.read();
        for (int i = 0; i < surfels.capacity; ++i)
            expect_close(rgb_at(got, static_cast<std::size_t>(surfels.capacity), i), expected[static_cast<std::size_t>(i)],
                         tolerance::accumulation, "surfel " + std::to_string(i) + " of " + std::to_string(count));
    }
}

TEST(ProjectContacts, NoContactsNoLaunch) {
    Kernels kernels = make_kernels();
    const MadeSurfels surfels(16);
    Buffer<float> outgoing = filled_rgb(surfels.capacity, 1);
    project_contacts(kernels, surfels.on_device(), {}, SurfacePencils(device(), 1, contact_map), outgoing);
    for (const float value : outgoing.read()) EXPECT_EQ(value, 1);
}

}  // namespace
