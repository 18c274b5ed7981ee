// Pencils on every sixteenth texel of the world set, reflected.
#include "bench/surface_bench.h"
#include "surface/project_contacts.h"

namespace pencil::bench {
namespace {

void bench_project_contacts(benchmark::State& state) {
    WorldBench& bench = world_bench();
    const Surfels& surfels = bench.world.surfels();
    Contacts contacts;
    for (int i = 0; i < surfels.count; i += contact_block) {
        contacts.chosen.add(i + i / contact_block % contact_block, 0, glm::vec3(0));
        contacts.counts.push_back(static_cast<float>(1 + i % contact_block));
    }
    const int count = static_cast<int>(contacts.counts.size());
    SurfacePencils pencils(device(), count, contact_map);
    pencils.count = count;
    const std::vector<float4> irradiance(contacts.counts.size(), float4(1, 2, 3, 0));
    pencils.irradiance.write(irradiance);
    Buffer<float> outgoing = surfel_rgb(device(), surfels.capacity, "outgoing");
    std::vector<float> native_outgoing(static_cast<std::size_t>(surfels.capacity) * 3);
    compare(
        state, {product(surfels.count, "surfels", count, "contacts"), static_cast<double>(count), 60.0 * count, {"project contacts"}},
        [&] { project_contacts(bench.kernels, surfels, contacts, pencils, outgoing); },
        [&] {
            native::project_contacts(bench.surfels(), contacts.chosen.surfels.data(), contacts.counts.data(), count, irradiance.data(),
                                     {native_outgoing.data(), bench.surfels().capacity});
        },
        [&] {
            return differences(used_rgb(outgoing.read(), surfels.capacity, surfels.count),
                               used_rgb(native_outgoing, surfels.capacity, surfels.count), 1e-3, 1e-3);
        });
}
BENCHMARK(bench_project_contacts)->Name("project_contacts")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
