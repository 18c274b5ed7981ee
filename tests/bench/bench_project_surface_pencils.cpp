// The texels of the world set lit by the world set.
#include "bench/surface_bench.h"
#include "surface/project_surface_pencils.h"

namespace pencil::bench {
namespace {

void bench_project_surface_pencils(benchmark::State& state) {
    WorldBench& bench = world_bench();
    const Surfels& surfels = bench.world.surfels();
    const SurfacePencils& world = bench.world.pencils();
    Buffer<unsigned char> contact(device(), static_cast<std::size_t>(surfels.capacity), "contacts");
    Buffer<float> outgoing = surfel_rgb(device(), surfels.capacity, "outgoing");
    std::vector<float> native_outgoing(static_cast<std::size_t>(surfels.capacity) * 3);
    compare(
        state,
        {product(surfels.count, "surfels", bench.world.pencils().count, "pencils"),
         bench.texels(),
         64.0 * bench.texels(),
         {"project surface pencils"}},
        [&] {
            project_surface_pencils(bench.kernels, bench.scene, surfels, world, world.irradiance, bench.world.grid(), {world, 0}, 0,
                                    outgoing, contact);
        },
        [&] {
            native::project_surface_pencils(bench.surfels(), bench.pencils.data(), bench.irradiance.data(), bench.grid_view(),
                                            {native_outgoing.data(), bench.surfels().capacity});
        },
        [&] {
            return differences(used_rgb(outgoing.read(), surfels.capacity, surfels.count),
                               used_rgb(native_outgoing, surfels.capacity, surfels.count), 1e-3, 1e-3);
        });
}
BENCHMARK(bench_project_surface_pencils)->Name("project_surface_pencils")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
