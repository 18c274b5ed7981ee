// One bounce of the world set.
#include "bench/surface_bench.h"
#include "surface/transport_irradiance.h"

namespace pencil::bench {
namespace {

void bench_transport_irradiance(benchmark::State& state) {
    WorldBench& bench = world_bench();
    const int count = bench.world.pencils().count, n = bench.world.pencils().n;
    const std::vector<glm::ivec4> pencils = bench.world.links().pencils.read();
    const std::vector<float4> weights = bench.world.links().weights.read(), dark(bench.pencils.size(), float4(0));
    const Buffer<float4> source(device(), bench.irradiance, "source");
    Buffer<float4> target(device(), dark, "target"), total(device(), dark, "total");
    std::vector<float4> native_target = dark, native_total = dark;
    compare(
        state,
        {product(count, "pencils", n * n, "texels"), bench.texels(), (32.0 + 12.0 + 64.0) * bench.texels(), {"transport irradiance"}},
        [&] { transport_irradiance(bench.kernels, bench.world.surfels(), bench.world.links(), count, n, source, target, total); },
        [&] {
            native::transport_irradiance(bench.surfels(), pencils.data(), weights.data(), count, n, bench.irradiance.data(),
                                         native_target.data(), native_total.data());
        },
        [&] {
            const std::string wrong = differences(floats(target.read()), floats(native_target), 1e-4, 0);
            return wrong.empty() ? differences(floats(total.read()), floats(native_total), 1e-4, 0) : wrong;
        });
}
BENCHMARK(bench_transport_irradiance)->Name("transport_irradiance")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
