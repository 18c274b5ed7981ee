// Emission that the texels of the world set see.
#include "bench/surface_bench.h"
#include "pencils/light_samples.h"
#include "surface/emit_hemispheres.h"

namespace pencil::bench {
namespace {

void bench_emit_hemispheres(benchmark::State& state) {
    WorldBench& bench = world_bench();
    const Surfels& surfels = bench.world.surfels();
    const std::vector<float> near = near_areas(workbench().flat, bench.lights.samples.read());
    const Buffer<float> near_area(device(), near, "near areas");
    Buffer<float> radiance = surfel_rgb(device(), surfels.capacity, "emission");
    std::vector<float> native_radiance(static_cast<std::size_t>(surfels.capacity) * 3);
    compare(
        state, {std::to_string(surfels.count) + " surfels", bench.texels(), 4.0 * bench.texels(), {"emission"}},
        [&] {
            emit_hemispheres(bench.kernels, bench.scene, surfels, {bench.world.pencils(), 0}, near_area, radiance);
        },
        [&] {
            native::emit_hemispheres(workbench().view(), bench.surfels(), bench.pencils.data(), bench.world.pencils().n, near.data(),
                                     {native_radiance.data(), bench.surfels().capacity});
        },
        [&] {
            return differences(used_rgb(radiance.read(), surfels.capacity, surfels.count),
                               used_rgb(native_radiance, surfels.capacity, surfels.count), 1e-3, 0);
        });
}
BENCHMARK(bench_emit_hemispheres)->Name("emit_hemispheres")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
