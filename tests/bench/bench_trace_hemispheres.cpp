// What the texels of the world set see, by rays through the hierarchy.
#include "bench/surface_bench.h"
#include "pencils/low_discrepancy.h"
#include "surface/trace_hemispheres.h"

namespace pencil::bench {
namespace {

void bench_trace_hemispheres(benchmark::State& state) {
    WorldBench& bench = world_bench();
    const SurfacePencils& pencils = bench.world.pencils();
    const TexelPoints points{5, 3};
    Surfels surfels(device(), pencils.count * pencils.texels(), "surfels");
    std::vector<float> seen(surfels.data.size());
    compare(
        state, {product(pencils.count, "pencils", pencils.texels(), "rays"), bench.texels(), 56.0 * bench.texels(), {"trace hemispheres"}},
        [&] { trace_hemispheres(bench.kernels, bench.scene, pencils, 0, pencils.count, points, surfels); },
        [&] {
            native::trace_hemispheres(workbench().view(), bench.bvh_view(), bench.pencils.data(), pencils.count, pencils.n, points.seed,
                                      sobol_2d(points.turn), seen.data(), static_cast<std::size_t>(surfels.capacity));
        },
        [&] {
            const auto used = [&](const std::vector<float>& fields) {  // positions
                return used_rgb({fields.begin(), fields.begin() + 3 * surfels.capacity}, surfels.capacity, surfels.count);
            };
            return differences(used(surfels.data.read()), used(seen), 1e-4, 1e-3);
        });
}
BENCHMARK(bench_trace_hemispheres)->Name("trace_hemispheres")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
