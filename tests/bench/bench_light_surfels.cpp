// Direct light of the film's surfels.
#include "bench/workbench.h"
#include "film/light_surfels.h"

namespace pencil::bench {
namespace {

void bench_light_surfels(benchmark::State& state) {
    Workbench& bench = workbench();
    const Surfels& surfels = bench.film.surfels();
    const HostMaps maps(bench.lights.maps, bench.view());
    const HostSurfels host(surfels);
    const std::vector<LightSample> samples = bench.lights.samples.read();
    Buffer<float> outgoing = surfel_rgb(device(), surfels.capacity, "outgoing");
    std::vector<float> native_outgoing(static_cast<std::size_t>(surfels.capacity) * 3);
    const double pairs = static_cast<double>(surfels.count) * maps.view().count;
    compare(
        state, {product(surfels.count, "surfels", maps.view().count, "light samples"), pairs, pairs * sizeof(glm::ivec2), {"direct light"}},
        [&] { light_surfels(bench.kernels, bench.on_device, surfels, bench.lights, outgoing, "direct light"); },
        [&] {
            native::light_surfels(bench.view(), host.view(), samples.data(), maps.view(), {native_outgoing.data(), host.view().capacity});
        },
        [&] {
            return differences(used_rgb(outgoing.read(), host.capacity, host.count), used_rgb(native_outgoing, host.capacity, host.count),
                               1e-3, 1e-3);
        });
}
BENCHMARK(bench_light_surfels)->Name("light_surfels")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
