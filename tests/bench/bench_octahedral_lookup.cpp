// Bilinear look-ups in octahedral tiles, in the buffer and in an image, by a kernel of the benchmark's own: the core of the transport kernels.
#include "bench/workbench.h"
#include "device/radiance_atlas.h"

namespace pencil::bench {
namespace {

constexpr const char* kernel_file = PENCIL_SOURCE_DIR "/tests/bench/octahedral_lookup.cl";

std::vector<float> components(const std::vector<float4>& texels) {
    std::vector<float> out;
    for (const float4& t : texels) out.insert(out.end(), {t.x, t.y, t.z, t.w});
    return out;
}

/// The same texels as an image.
const TexelImage& radiance_image(const PencilSet& set) {
    static RadianceAtlas atlas(device());
    return atlas.image_of(set);
}

template <typename Radiance>
void look_up(benchmark::State& state, const Radiance& atlas, bool image) {
    Workbench& bench = workbench();
    const Surfels& surfels = bench.texel_surfels;
    const HostMaps maps(*bench.set.maps, bench.view());
    const HostSurfels host(surfels);
    const std::vector<float4> radiance = bench.set.radiance.read();
    const int count = surfels.count, tiles = maps.view().count;
    std::vector<Buffer<float>> position;
    for (int f = SURFEL_X; f <= SURFEL_Z; ++f) {
        const float* values = host.view().field(f);
        position.emplace_back(device(), std::vector<float>(values, values + surfels.capacity), "positions");
    }
    Buffer<float4> sum(device(), static_cast<std::size_t>(surfels.capacity), "sums");
    std::vector<float4> native_sum(sum.size());
    const double lookups = static_cast<double>(count) * tiles;
    compare(
        state, {product(count, "points", tiles, "tiles"), lookups, lookups * 4 * sizeof(float4), {"octahedral look-up"}},
        [&] {
            const Kernels& kernels = bench.kernels;
            bench.kernels.cache()
                .kernel("octahedral_lookup", kernel_file,
                        {{"PENCIL_BLOCK", std::to_string(kernels.block())},
                         {"PENCIL_MAP_KIND", std::to_string(PENCIL_MAP_OCTAHEDRAL)},
                         {"PENCIL_ATLAS_IMAGE", image ? "1" : "0"}})
                .args(position[0], position[1], position[2], count, bench.set.maps->cops, tiles, maps.n, atlas, sum)
                .run(kernels.blocks(count), "octahedral look-up");
        },
        [&] {
            native::octahedral_lookup(host.view().field(SURFEL_X), host.view().field(SURFEL_Y), host.view().field(SURFEL_Z), count,
                                      maps.view(), radiance.data(), native_sum.data());
        },
        [&] { return differences(components(sum.read()), components(native_sum), image ? 1e-2 : 1e-3, 0); });
}

void bench_octahedral_lookup(benchmark::State& state) { look_up(state, workbench().set.radiance, false); }
void bench_octahedral_lookup_image(benchmark::State& state) {
    if (image_limits(*device()).layers == 0) return state.SkipWithError("no images on this device");
    look_up(state, radiance_image(workbench().set), true);
}

BENCHMARK(bench_octahedral_lookup)->Name("octahedral_lookup")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(bench_octahedral_lookup_image)->Name("octahedral_lookup/image")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
