// Visibility samples of the film, rasterised and traced.
#include "bench/film_bench.h"
#include "bench/surface_bench.h"
#include "film/rasterize_film.h"
#include "film/trace_film.h"

namespace pencil::bench {
namespace {

std::vector<int> triangles_of(const std::vector<Hit>& hits) {
    std::vector<int> out;
    out.reserve(hits.size());
    for (const Hit& hit : hits) out.push_back(hit.triangle);
    return out;
}

void rasterize(benchmark::State& state) {
    Workbench& bench = workbench();
    FilmBench film;
    const int rows = sizes().film, samples = sizes().film_samples;
    const double count = static_cast<double>(film.hits.size());
    compare(
        state, {product(static_cast<long long>(rows) * rows, "pixels", samples, "samples"), count, count * sizeof(Hit), {"bench film"}},
        [&] {
            rasterize_film(bench.kernels, bench.on_device, bench.flat.camera, film.device_offsets, samples, 0, rows, film.hits,
                           "bench film");
        },
        [&] { film.rasterize_native(); },
        [&] { return differences(triangles_of(film.hits.read()), triangles_of(film.native_hits), 1e-4); });
}
/// The native partner rasterises, too.
void trace(benchmark::State& state) {
    const WorldBench& world = world_bench();
    FilmBench film;
    const int rows = sizes().film, samples = sizes().film_samples;
    const double count = static_cast<double>(film.hits.size());
    compare(
        state, {product(static_cast<long long>(rows) * rows, "pixels", samples, "samples"), count, count * sizeof(Hit), {"bench film"}},
        [&] {
            trace_film(world.kernels, world.scene, workbench().flat.camera, film.device_offsets, samples, 0, rows, film.hits, "bench film");
        },
        [&] { film.rasterize_native(); },
        [&] { return differences(triangles_of(film.hits.read()), triangles_of(film.native_hits), 1e-4); });
}

BENCHMARK(rasterize)->Name("rasterize_film")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(trace)->Name("trace_film")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
