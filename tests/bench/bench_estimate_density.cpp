// 1/D of the texels of a set.
#include "bench/workbench.h"
#include "line/estimate_density.h"
#include "line/gather_surfels.h"
#include "line/test_visibility.h"

namespace pencil::bench {
namespace {

void bench_estimate_density(benchmark::State& state) {
    Workbench& bench = workbench();
    GeometryMaps& maps = *bench.set.maps;
    const int tiles = std::min(sizes().tiles, maps.count), n = maps.n;
    Surfels surfels(device(), tiles * n * n, "surfels");
    gather_surfels(bench.kernels, bench.on_device, maps, 0, tiles, surfels);
    Buffer<uint> mask(device(), static_cast<std::size_t>(mask_words(maps.count)) * static_cast<std::size_t>(surfels.capacity), "mask");
    test_visibility(bench.kernels, bench.on_device, surfels, maps, mask);
    const HostSurfels host(surfels);
    const std::vector<uint> host_mask = mask.read();
    const std::vector<float4> cops = maps.cops.read();
    std::vector<float4> native_radiance = bench.set.radiance.read();
    const double pairs = static_cast<double>(surfels.count) * maps.count;
    // Centres and mask bits; a surfel's own data once.
    const double bytes = pairs * (sizeof(float4) + 1.0 / 8) + 7.0 * sizeof(float) * surfels.count;
    compare(
        state, {product(surfels.count, "surfels", maps.count, "pencils"), pairs, bytes, {"pencil density"}},
        [&] { estimate_density(bench.kernels, surfels, mask, 0, bench.set); },
        [&] { native::estimate_density(host.view(), cops.data(), maps.count, host_mask.data(), 0, n, native_radiance.data()); },
        [&] {
            std::vector<float> got, expected;
            for (const float4& texel : bench.set.radiance.read()) got.push_back(texel.w);
            for (const float4& texel : native_radiance) expected.push_back(texel.w);
            return differences(got, expected, 1e-3, 0);
        });
}
BENCHMARK(bench_estimate_density)->Name("estimate_density")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
