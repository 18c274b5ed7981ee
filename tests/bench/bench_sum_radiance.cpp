// Mean radiance of a pencil set.
#include "bench/workbench.h"
#include "line/sum_radiance.h"

namespace pencil::bench {
namespace {

void bench_sum_radiance(benchmark::State& state) {
    Workbench& bench = workbench();
    const std::vector<float4> radiance = bench.set.radiance.read();
    const int count = bench.set.maps->count, n = bench.set.maps->n;
    std::vector<float4> means(static_cast<std::size_t>(count));
    glm::dvec3 got(0.0);
    const double texels = static_cast<double>(count) * n * n;
    compare(
        state, {product(count, "tiles", static_cast<long long>(n) * n, "texels"), texels, texels * sizeof(float4), {"mean radiance"}},
        [&] { got = sum_radiance(bench.kernels, bench.set); }, [&] { native::sum_radiance(radiance.data(), count, n, means.data()); },
        [&] {
            glm::dvec3 mean(0.0);
            for (const float4& m : means) mean += glm::dvec3(m) / static_cast<double>(count);
            const auto floats = [](const glm::dvec3& v) { return std::vector<float>{float(v.x), float(v.y), float(v.z)}; };
            return differences(floats(got), floats(mean), 1e-5, 0);
        });
}
BENCHMARK(bench_sum_radiance)->Name("sum_radiance")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
