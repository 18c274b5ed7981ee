// Harmonic mean distance and horizon of the world set.
#include "bench/surface_bench.h"
#include "surface/measure_hemispheres.h"

namespace pencil::bench {
namespace {

void bench_measure_hemispheres(benchmark::State& state) {
    WorldBench& bench = world_bench();
    std::vector<SurfacePencil> measured = bench.pencils;
    SurfacePencils pencils(device(), static_cast<int>(measured.size()), bench.world.pencils().n);  // the set's own stay as they are
    pencils.data.write(measured);
    pencils.count = static_cast<int>(measured.size());
    compare(
        state,
        {product(pencils.count, "pencils", pencils.texels(), "texels"), bench.texels(), 16.0 * bench.texels(), {"measure hemispheres"}},
        [&] { measure_hemispheres(bench.kernels, bench.world.surfels(), 0, 0, pencils.count, pencils); },
        [&] { native::measure_hemispheres(bench.surfels(), pencils.count, pencils.n, measured.data()); },
        [&] {
            const auto list = [](const std::vector<SurfacePencil>& from) {
                std::vector<float> to;
                for (const SurfacePencil& p : from) {
                    to.push_back(p.position.w);
                    to.insert(to.end(), p.horizon_x, p.horizon_x + 2 * RING_SECTORS);
                    to.insert(to.end(), p.horizon_y, p.horizon_y + 2 * RING_SECTORS);
                }
                return to;
            };
            return differences(list(pencils.data.read(0, measured.size())), list(measured), 1e-3, 1e-3);
        });
}
BENCHMARK(bench_measure_hemispheres)->Name("measure_hemispheres")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
