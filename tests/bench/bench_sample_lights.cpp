// Direct light of the world set's texels by drawn light samples.
#include "bench/surface_bench.h"
#include "surface/sample_lights.h"

namespace pencil::bench {
namespace {

void bench_sample_lights(benchmark::State& state) {
    WorldBench& bench = world_bench();
    const Surfels& surfels = bench.world.surfels();
    const std::vector<LightSample> samples = bench.lights.samples.read();
    const int count = static_cast<int>(samples.size()), draws = 2, stride = std::max(count / 24, 1);
    Buffer<float> outgoing = surfel_rgb(device(), surfels.capacity, "outgoing");
    std::vector<float> native_outgoing(static_cast<std::size_t>(surfels.capacity) * 3);
    const double pairs = bench.texels() * count / stride;
    compare(
        state,
        {product(surfels.count, "surfels", count / stride, "light samples"), pairs, pairs * 4.0, {"direct light to surface pencils"}},
        [&] { sample_lights(bench.kernels, bench.scene, surfels, bench.lights, stride, draws, 7, outgoing); },
        [&] {
            native::sample_lights(workbench().view(), bench.bvh_view(), bench.surfels(), samples.data(), count, LIGHT_SURFELS, stride,
                                  draws, 7, {native_outgoing.data(), bench.surfels().capacity});
        },
        [&] {
            // Rounding may turn a draw.
            return differences(used_rgb(outgoing.read(), surfels.capacity, surfels.count),
                               used_rgb(native_outgoing, surfels.capacity, surfels.count), 1e-3, 1e-2);
        });
}
BENCHMARK(bench_sample_lights)->Name("sample_lights")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
