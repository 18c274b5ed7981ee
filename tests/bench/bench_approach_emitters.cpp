// Distance of the emitters that the world set sees.
#include "bench/surface_bench.h"
#include "pencils/light_samples.h"
#include "surface/approach_emitters.h"

namespace pencil::bench {
namespace {

std::vector<float> distances(const std::vector<SurfacePencil>& pencils) {
    std::vector<float> out;
    for (const SurfacePencil& p : pencils) out.push_back(std::min(p.emitters, 1e6F));
    return out;
}

void bench_approach_emitters(benchmark::State& state) {
    WorldBench& bench = world_bench();
    std::vector<SurfacePencil> measured = bench.pencils;
    SurfacePencils pencils(device(), static_cast<int>(measured.size()), bench.world.pencils().n);  // the set's own stay as they are
    pencils.data.write(measured);
    pencils.count = static_cast<int>(measured.size());
    const std::vector<float> near = near_areas(workbench().flat, bench.lights.samples.read());
    const Buffer<float> near_area(device(), near, "near areas");
    compare(
        state, {product(pencils.count, "pencils", pencils.texels(), "texels"), bench.texels(), 8.0 * bench.texels(), {"approach emitters"}},
        [&] { approach_emitters(bench.kernels, bench.scene, bench.world.surfels(), 0, pencils.count, near_area, pencils); },
        [&] { native::approach_emitters(workbench().view(), bench.surfels(), pencils.count, pencils.n, near.data(), measured.data()); },
        [&] { return differences(distances(pencils.data.read(0, measured.size())), distances(measured), 1e-3, 1e-3); });
}
BENCHMARK(bench_approach_emitters)->Name("approach_emitters")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
