// Surfels of the film that the lattice of film pencils does not cover.
#include "bench/surface_bench.h"
#include "surface/cover_film.h"

namespace pencil::bench {
namespace {

void bench_cover_film(benchmark::State& state) {
    LatticeBench& bench = lattice_bench();
    const int count = bench.host_surfels.count;
    constexpr float most_error = 0.26F;
    std::vector<unsigned char> native_uncovered(static_cast<std::size_t>(bench.host_surfels.capacity), 1);
    Buffer<unsigned char> uncovered(device(), native_uncovered, "uncovered");
    compare(
        state, {product(count, "surfels", bench.pencils.count, "pencils"), static_cast<double>(count), 24.0 * count, {"cover film"}},
        [&] { cover_film(workbench().kernels, bench.shown(), bench.lattice(), most_error, uncovered); },
        [&] { native::cover_film(bench.view(), most_error, native_uncovered.data()); },
        [&] {
            const std::vector<unsigned char> got = uncovered.read();
            return differences(std::vector<int>(got.begin(), got.end()), std::vector<int>(native_uncovered.begin(), native_uncovered.end()),
                               1e-3);
        });
}
BENCHMARK(bench_cover_film)->Name("cover_film")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
