// The tail of the series of bounces, for a set of many pencils.
#include "bench/surface_bench.h"
#include "surface/close_series.h"

namespace pencil::bench {
namespace {

void bench_close_series(benchmark::State& state) {
    WorldBench& bench = world_bench();
    const int count = bench.world.surfels().count;
    const std::vector<float4> last(static_cast<std::size_t>(count), float4(3, 2, 1, 0));
    const Buffer<float4> on_device(device(), last, "last");
    const glm::vec3 tail(0.5F, 0.25F, 0.125F);
    Buffer<float4> total(device(), last, "total");
    std::vector<float4> native_total = last;
    compare(
        state, {std::to_string(count) + " pencils", static_cast<double>(count), 48.0 * count, {"close series"}},
        [&] { close_series(bench.kernels, on_device, tail, count, total); },
        [&] { native::close_series(last.data(), float4(tail, 0), count, native_total.data()); },
        [&] { return differences(floats(total.read()), floats(native_total), 1e-6, 0); });
}
BENCHMARK(bench_close_series)->Name("close_series")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
