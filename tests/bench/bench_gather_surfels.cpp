// Surfels that the texels of a set see.
#include "bench/workbench.h"
#include "line/gather_surfels.h"

namespace pencil::bench {
namespace {

void bench_gather_surfels(benchmark::State& state) {
    Workbench& bench = workbench();
    const HostMaps maps(*bench.next_maps, bench.view());
    Surfels& surfels = bench.texel_surfels;
    std::vector<float> native_surfels(surfels.data.size());
    const double bytes = static_cast<double>(surfels.count) * (sizeof(Hit) + SURFEL_FIELDS * sizeof(float));
    compare(
        state, {std::to_string(surfels.count) + " surfels", static_cast<double>(surfels.count), bytes, {"gather surfels"}},
        [&] { gather_surfels(bench.kernels, bench.on_device, *bench.next_maps, 0, sizes().tiles, surfels); },
        [&] {
            native::gather_surfels(bench.view(), maps.view(), 0, sizes().tiles, native_surfels.data(),
                                   static_cast<std::size_t>(surfels.capacity));
        },
        [&] {
            // Integer fields are bits of floats: NaN or denormal, compared apart by the kernel's own tests.
            const auto used = [&](const std::vector<float>& all) {
                return std::vector<float>(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(SURFEL_PLANE) * surfels.capacity);
            };
            return differences(used(surfels.data.read()), used(native_surfels), 1e-5, 0);
        });
}
BENCHMARK(bench_gather_surfels)->Name("gather_surfels")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
