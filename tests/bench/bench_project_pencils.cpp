// Pencil transport (surfels of the next set's texels) and projection-scatter (surfels of the film): the hot loop, one kernel.
#include "bench/workbench.h"
#include "line/project_pencils.h"

namespace pencil::bench {
namespace {

/// Per surfel and pencil: four texels and one cell. The surfels themselves are read once for all pencils.
constexpr double pair_bytes = 4 * sizeof(float4) + sizeof(glm::ivec2);

void project(benchmark::State& state, const Surfels& surfels, const std::string& what) {
    Workbench& bench = workbench();
    const HostMaps maps(*bench.set.maps, bench.view());
    const HostSurfels host(surfels);
    const std::vector<float4> radiance = bench.set.radiance.read();
    WeightTables tables(bench.kernels);
    Buffer<float> outgoing = surfel_rgb(device(), surfels.capacity, "outgoing");
    Buffer<int> visible(device(), static_cast<std::size_t>(surfels.capacity), "visible");
    std::vector<float> native_outgoing(static_cast<std::size_t>(surfels.capacity) * 3);
    std::vector<int> native_visible(static_cast<std::size_t>(surfels.capacity));
    const double pairs = static_cast<double>(surfels.count) * maps.view().count;
    compare(
        state, {product(surfels.count, "surfels", maps.view().count, "pencils"), pairs, pairs * pair_bytes, {what}},
        [&] { project_pencils(bench.kernels, bench.on_device, surfels, bench.set, tables, outgoing, visible, what); },
        [&] {
            native::project_pencils(bench.view(), host.view(), maps.view(), radiance.data(), {native_outgoing.data(), host.view().capacity},
                                    native_visible.data());
        },
        [&] {
            std::vector<int> seen = visible.read();
            seen.resize(static_cast<std::size_t>(surfels.count));
            native_visible.resize(seen.size());
            const std::string counts = differences(seen, native_visible, 1e-3);
            native_visible.resize(static_cast<std::size_t>(surfels.capacity));
            return counts + differences(used_rgb(outgoing.read(), host.capacity, host.count),
                                        used_rgb(native_outgoing, host.capacity, host.count), 1e-4, 1e-3);
        });
}

void bench_project_pencils_transport(benchmark::State& state) { project(state, workbench().texel_surfels, "pencil transport"); }
void bench_project_pencils_projection_scatter(benchmark::State& state) { project(state, workbench().film.surfels(), "projection-scatter"); }

BENCHMARK(bench_project_pencils_transport)->Name("project_pencils/transport")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(bench_project_pencils_projection_scatter)
    ->Name("project_pencils/projection-scatter")
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
