// Film pencils fitted with their neighbours.
#include "bench/surface_bench.h"
#include "surface/smooth_irradiance.h"

namespace pencil::bench {
namespace {

void bench_smooth_irradiance(benchmark::State& state) {
    LatticeBench& bench = lattice_bench();
    const FilmSurfels film = bench.shown();
    constexpr float most_error = 0.325F;
    Buffer<float4> fits(device(), 3 * bench.host_pencils.size(), "fits");
    std::vector<float4> native_fits(fits.size());
    const auto count = static_cast<double>(bench.pencils.count);
    compare(
        state,
        {product(bench.pencils.count, "pencils", 25, "neighbours"), 25 * count, 25 * count * sizeof(SurfacePencil), {"smooth irradiance"}},
        [&] { smooth_irradiance(workbench().kernels, bench.lattice(), most_error, film.width, film.height, fits); },
        [&] { native::smooth_irradiance(bench.view(), bench.irradiance.data(), most_error, native_fits.data()); },
        [&] { return differences(floats(fits.read()), floats(native_fits), 1e-2, 1e-2); });
}
BENCHMARK(bench_smooth_irradiance)->Name("smooth_irradiance")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
