// Emission of the texels' surfels.
#include "bench/workbench.h"
#include "film/emit_surfels.h"

namespace pencil::bench {
namespace {

void bench_emit_surfels(benchmark::State& state) {
    Workbench& bench = workbench();
    const Surfels& surfels = bench.texel_surfels;
    const HostSurfels host(surfels);
    Buffer<float> radiance = surfel_rgb(device(), surfels.capacity, "emission");
    std::vector<float> native_radiance(static_cast<std::size_t>(surfels.capacity) * 3);
    compare(
        state, {std::to_string(surfels.count) + " surfels", static_cast<double>(surfels.count), 4.0 * surfels.count, {"emission"}},
        [&] { emit_surfels(bench.kernels, bench.on_device, surfels, false, radiance); },
        [&] {
            native::emit_surfels(bench.view(), host.view(), {native_radiance.data(), host.view().capacity});
        },
        [&] { return differences(radiance.read(), native_radiance, 1e-6, 0); });
}
BENCHMARK(bench_emit_surfels)->Name("emit_surfels")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
