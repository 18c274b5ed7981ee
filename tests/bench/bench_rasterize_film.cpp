// Visibility samples of the film.
#include "bench/film_bench.h"

namespace pencil::bench {
namespace {

constexpr int kBandRows = 8;  // as host/transport/film.cpp

std::vector<int> triangles_of(const std::vector<Hit>& hits) {
    std::vector<int> out;
    out.reserve(hits.size());
    for (const Hit& hit : hits) out.push_back(hit.triangle);
    return out;
}

void rasterize(benchmark::State& state) {
    Workbench& bench = workbench();
    FilmBench film;
    const int rows = sizes().film, samples = sizes().film_samples, bands = (rows + kBandRows - 1) / kBandRows;
    const double count = static_cast<double>(film.hits.size());
    compare(
        state, {product(static_cast<long long>(rows) * rows, "pixels", samples, "samples"), count, count * sizeof(Hit), {"bench film"}},
        [&] {
            bench.kernels.get("rasterize_film")
                .args(bench.on_device.triangles, bench.on_device.triangle_count, bench.on_device.planes, bench.flat.camera,
                      bench.on_device.to_film, film.device_offsets, samples, 0, rows, kBandRows, film.hits)
                .run(static_cast<std::size_t>(bands) * static_cast<std::size_t>(samples), "bench film", 1);
        },
        [&] { film.rasterize_native(); },
        [&] { return differences(triangles_of(film.hits.read()), triangles_of(film.native_hits), 1e-4); });
}
BENCHMARK(rasterize)->Name("rasterize_film")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
