// Visibility masks of the texels of a set, for its density.
#include "bench/workbench.h"
#include "line/test_visibility.h"

namespace pencil::bench {
namespace {

void bench_test_visibility(benchmark::State& state) {
    Workbench& bench = workbench();
    const Surfels& surfels = bench.texel_surfels;
    const HostMaps maps(*bench.set.maps, bench.view());
    const HostSurfels host(surfels);
    const int pencils = maps.view().count;
    Buffer<uint> mask(device(), static_cast<std::size_t>(mask_words(pencils)) * static_cast<std::size_t>(surfels.capacity), "mask");
    std::vector<uint> native_mask(mask.size());
    const double pairs = static_cast<double>(surfels.count) * pencils;
    const double words = 4.0 * surfels.count * mask_words(pencils);
    compare(
        state, {product(surfels.count, "surfels", pencils, "pencils"), pairs, pairs * sizeof(glm::ivec2) + words, {"visibility masks"}},
        [&] { test_visibility(bench.kernels, bench.on_device, surfels, *bench.set.maps, mask); },
        [&] { native::test_visibility(bench.view(), host.view(), maps.view(), native_mask.data()); },
        [&] {
            const std::vector<uint> got = mask.read();
            return differences(std::vector<int>(got.begin(), got.end()), std::vector<int>(native_mask.begin(), native_mask.end()), 1e-3);
        });
}
BENCHMARK(bench_test_visibility)->Name("test_visibility")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
