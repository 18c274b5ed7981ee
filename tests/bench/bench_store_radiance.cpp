// Outgoing radiance into maps: store_radiance and smooth_radiance, launched together.
#include "bench/workbench.h"
#include "line/store_radiance.h"

namespace pencil::bench {
namespace {

std::vector<float> components(const std::vector<float4>& texels) {
    std::vector<float> out;
    for (const float4& t : texels) out.insert(out.end(), {t.x, t.y, t.z});
    return out;
}

void bench_store_radiance(benchmark::State& state) {
    Workbench& bench = workbench();
    PencilSet set(device(), bench.next_maps);
    const int tiles = sizes().tiles, n = bench.next_maps->n;
    set.radiance.fill_zero();
    const Surfels& surfels = bench.texel_surfels;
    std::vector<float> values(static_cast<std::size_t>(surfels.capacity) * 3);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i * 7919 % 1024) / 1024.0F;
    const Buffer<float> outgoing(device(), values, "outgoing");
    std::vector<float4> native_radiance(set.radiance.size());
    const double texels = static_cast<double>(surfels.count);
    compare(
        state,
        {product(tiles, "tiles", static_cast<long long>(n) * n, "texels"),
         texels,
         texels * (3 * sizeof(float) + sizeof(float4)),
         {"store radiance", "smooth radiance maps"}},
        [&] { store_radiance(bench.kernels, surfels, outgoing, 0, tiles, set); },
        [&] { native::store_radiance(values.data(), static_cast<std::size_t>(surfels.capacity), tiles, n, native_radiance.data()); },
        [&] { return differences(components(set.radiance.read()), components(native_radiance), 1e-5, 0); });
}
BENCHMARK(bench_store_radiance)->Name("store_radiance")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
