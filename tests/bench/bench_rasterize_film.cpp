// Visibility samples of the film, rasterised and traced.
#include "bench/film_bench.h"
#include "bench/surface_bench.h"
#include "film/rasterize_film.h"
#include "film/trace_film.h"

namespace pencil::bench {
namespace {

/// Either way to find the samples against native rasterisation.
template <typename Look>
void see(benchmark::State& state, Look look) {
    const Camera& camera = workbench().flat.camera;
    FilmBench film;
    const int rows = sizes().film, samples = sizes().film_samples;
    const double count = static_cast<double>(film.hits.size());
    compare(
        state, {product(static_cast<long long>(rows) * rows, "pixels", samples, "samples"), count, count * sizeof(Hit), {"bench film"}},
        [&] { look(camera, film.device_offsets, samples, rows, film.hits); }, [&] { film.rasterize_native(); },
        [&] { return differences(triangles_of(film.hits.read()), triangles_of(film.native_hits), 1e-4); });
}

void bench_rasterize_film(benchmark::State& state) {
    see(
        state,
        [](const auto& camera, const auto& offsets, int samples, int rows, auto& hits) {
            rasterize_film(workbench().kernels, workbench().on_device, camera, offsets, samples, 0, rows, hits, "bench film");
        });
}
void bench_trace_film(benchmark::State& state) {
    see(
        state,
        [](const auto& camera, const auto& offsets, int samples, int rows, auto& hits) {
            trace_film(world_bench().kernels, world_bench().scene, camera, offsets, samples, 0, rows, hits, "bench film");
        });
}
BENCHMARK(bench_rasterize_film)->Name("rasterize_film")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(bench_trace_film)->Name("trace_film")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
