// Footprints of the maps of a pencil set. The check is test_visibility's: the kernel and the native loop may name footprints differently,
// but gutters must agree.
#include "bench/workbench.h"
#include "visibility/rasterize_octahedral.h"

namespace pencil::bench {
namespace {

void bench_fold_hits(benchmark::State& state) {
    Workbench& bench = workbench();
    GeometryMaps maps(device(), bench.set.maps->cops.read(), bench.set.maps->n, "bench");
    HostMaps native_maps(*bench.set.maps, bench.view());
    const double texels = static_cast<double>(maps.count) * (maps.n + 1) * (maps.n + 1);
    compare(
        state,
        {product(maps.count, "tiles", static_cast<long long>(maps.n + 1) * (maps.n + 1), "footprints"),
         texels,
         texels * (sizeof(Hit) + sizeof(glm::ivec2) + sizeof(glm::ivec4)),
         {"fold geometry maps"}},
        [&] { rasterize_octahedral(bench.kernels, bench.on_device, maps, 0, maps.count); },
        [&] {
            native::fold_hits(bench.view(), native_maps.cops.data(), maps.count, maps.n, native_maps.hits.data(), native_maps.cells.data(),
                              native_maps.groups.data());
        },
        [&] {
            std::vector<int> got, expected;
            for (const Hit& hit : maps.hits.read()) got.push_back(hit.triangle);
            for (const Hit& hit : native_maps.hits) expected.push_back(hit.triangle);
            return differences(got, expected, 0);
        });
}
BENCHMARK(bench_fold_hits)->Name("fold_hits")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
