// Which pencils of the world set light each of its texels.
#include "bench/surface_bench.h"
#include "surface/link_surfels.h"

namespace pencil::bench {
namespace {

void bench_link_surfels(benchmark::State& state) {
    WorldBench& bench = world_bench();
    const Surfels& surfels = bench.world.surfels();
    SurfaceLinks links;
    std::vector<glm::ivec4> pencils(static_cast<std::size_t>(surfels.count));
    std::vector<float4> weights(pencils.size());
    compare(
        state,
        {product(surfels.count, "surfels", bench.world.pencils().count, "pencils"),
         bench.texels(),
         76.0 * bench.texels(),
         {"link surfels"}},
        [&] { links = link_surfels(bench.kernels, bench.scene, surfels, bench.world.pencils(), bench.world.grid()); },
        [&] { native::link_surfels(bench.surfels(), bench.pencils.data(), bench.grid_view(), pencils.data(), weights.data()); },
        [&] {
            std::vector<float> sums[2];
            for (const bool own : {false, true})
                for (const float4& w : own ? links.weights.read() : weights)
                    sums[own ? 1 : 0].insert(sums[own ? 1 : 0].end(), {w.x, w.y, w.z, w.w});
            const std::string wrong = differences(sums[1], sums[0], 1e-3, 1e-3);
            std::vector<int> got, expected;
            for (const glm::ivec4& l : links.pencils.read()) got.push_back(l.x);
            for (const glm::ivec4& l : pencils) expected.push_back(l.x);
            return wrong.empty() ? differences(got, expected, 1e-3) : wrong;
        });
}
BENCHMARK(bench_link_surfels)->Name("link_surfels")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
