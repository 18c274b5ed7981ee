// Irradiance of the world set from the radiance of its texels.
#include "bench/surface_bench.h"
#include "surface/sum_hemispheres.h"

namespace pencil::bench {
namespace {

void bench_sum_hemispheres(benchmark::State& state) {
    WorldBench& bench = world_bench();
    const SurfacePencils& pencils = bench.world.pencils();
    const int capacity = bench.world.surfels().capacity;
    std::vector<float> radiance(static_cast<std::size_t>(capacity) * 3);
    for (std::size_t i = 0; i < radiance.size(); ++i) radiance[i] = static_cast<float>(1 + i % 11);
    const Buffer<float> on_device(device(), radiance, "radiance");
    Buffer<float4> irradiance(device(), bench.pencils.size(), "irradiance");
    std::vector<float4> sums(bench.pencils.size());
    compare(
        state, {product(pencils.count, "pencils", pencils.texels(), "texels"), bench.texels(), 12.0 * bench.texels(), {"sum hemispheres"}},
        [&] { sum_hemispheres(bench.kernels, on_device, capacity, 0, 0, pencils.count, pencils.n, irradiance); },
        [&] {
            native::sum_hemispheres({radiance.data(), static_cast<std::size_t>(capacity)}, pencils.count, pencils.n, sums.data());
        },
        [&] { return differences(floats(irradiance.read()), floats(sums), 1e-5, 0); });
}
BENCHMARK(bench_sum_hemispheres)->Name("sum_hemispheres")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
