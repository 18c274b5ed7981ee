// Geometry maps of pencils; rasterising and folding are launched together and timed apart.
#include "bench/workbench.h"
#include "visibility/rasterize_octahedral.h"

namespace pencil::bench {
namespace {

void rasterize(benchmark::State& state, const std::string& what, const GeometryMaps& centres) {
    Workbench& bench = workbench();
    GeometryMaps maps(device(), centres.cops.read(), centres.n, "bench");
    HostMaps native_maps(centres, bench.view());
    const double texels = static_cast<double>(maps.count) * maps.n * maps.n;
    const std::string scene = " texels, " + std::to_string(bench.on_device.triangle_count) + " triangles";
    compare(
        state,
        {product(maps.count, "tiles", static_cast<long long>(maps.n) * maps.n, scene.substr(1)), texels, texels * sizeof(Hit), {what}},
        [&] { rasterize_octahedral(bench.kernels, bench.on_device, maps, 0, maps.count); },
        [&] { native::rasterize_octahedral(bench.view(), native_maps.cops.data(), maps.count, maps.n, native_maps.hits.data()); },
        [&] { return differences(triangles_of(maps.hits.read()), triangles_of(native_maps.hits), 1e-4); });
}

void bench_rasterize_octahedral_pencils(benchmark::State& state) { rasterize(state, "rasterize octahedral maps", *workbench().set.maps); }
void bench_rasterize_octahedral_lights(benchmark::State& state) { rasterize(state, "rasterize octahedral maps", workbench().lights.maps); }

BENCHMARK(bench_rasterize_octahedral_pencils)->Name("rasterize_octahedral/pencils")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(bench_rasterize_octahedral_lights)->Name("rasterize_octahedral/lights")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
