// The film lit by the pencils of its lattice.
#include "bench/surface_bench.h"
#include "surface/project_film_pencils.h"

namespace pencil::bench {
namespace {

void bench_project_film_pencils(benchmark::State& state) {
    LatticeBench& bench = lattice_bench();
    const int count = bench.host_surfels.count, capacity = bench.host_surfels.capacity;
    constexpr float most_error = 0.52F;
    std::vector<float4> fits;
    for (const float4& e : bench.irradiance) fits.insert(fits.end(), {e, 0.1F * e, -0.1F * e});
    const std::vector<int> none(static_cast<std::size_t>(capacity), -1);
    const Buffer<float4> on_device(device(), fits, "fits");
    const Buffer<int> single_at(device(), none, "singles");
    Buffer<float> outgoing = surfel_rgb(device(), capacity, "outgoing");
    std::vector<float> native_outgoing(outgoing.size());
    compare(
        state,
        {product(count, "surfels", bench.pencils.count, "pencils"), static_cast<double>(count), 60.0 * count, {"project film pencils"}},
        [&] {
            project_film_pencils(workbench().kernels, bench.shown(), bench.lattice(), on_device, most_error, {bench.pencils, single_at},
                                 outgoing);
        },
        [&] {
            native::project_film_pencils(bench.view(), fits.data(), most_error, nullptr, none.data(),
                                         {native_outgoing.data(), static_cast<std::size_t>(capacity)});
        },
        [&] { return differences(used_rgb(outgoing.read(), capacity, count), used_rgb(native_outgoing, capacity, count), 1e-3, 1e-3); });
}
BENCHMARK(bench_project_film_pencils)->Name("project_film_pencils")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
