// Surfel values to pixels by the scene's filter. Slots are made on the host, one per plane that a pixel shows.
#include "bench/film_bench.h"
#include "shared/film.h"

namespace pencil::bench {
namespace {

struct Pixels {
    std::vector<unsigned char> slots, counts;
    std::vector<int> first_surfel;
    int surfels = 0;

    explicit Pixels(const FilmBench& film) {
        const std::size_t samples = film.offsets.size(), pixels = film.native_hits.size() / samples;
        const std::vector<Triangle>& triangles = workbench().flat.triangles;
        slots.assign(pixels * samples, NO_SURFEL);
        for (std::size_t p = 0; p < pixels; ++p) {
            std::vector<int> planes;
            bool empty = false;
            for (std::size_t s = 0; s < samples; ++s) {
                const int triangle = film.native_hits[s * pixels + p].triangle;
                empty = empty || triangle < 0;
                if (triangle < 0) continue;
                const int plane = triangles[static_cast<std::size_t>(triangle)].plane;
                const auto found = std::find(planes.begin(), planes.end(), plane);
                slots[p * samples + s] = static_cast<unsigned char>(found - planes.begin());
                if (found == planes.end()) planes.push_back(plane);
            }
            counts.push_back(static_cast<unsigned char>(planes.size() | (empty ? FILM_HAS_EMPTY : 0U)));
            first_surfel.push_back(surfels);
            surfels += static_cast<int>(planes.size());
        }
    }
};

void bench_resolve_film(benchmark::State& state) {
    Workbench& bench = workbench();
    FilmBench film;
    film.rasterize_native();
    const Pixels pixels(film);
    const FilterTable table = tabulate_filter(bench.scene.sensor.filter, film.offsets);
    const int capacity = surfel_capacity(pixels.surfels), side = sizes().film, samples = sizes().film_samples;
    std::vector<float> values(static_cast<std::size_t>(capacity) * 3);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i * 7919 % 1024) / 1024.0F;
    const Buffer<float> device_values(device(), values, "values"), weights(device(), table.weights, "weights"),
        totals(device(), table.totals, "totals");
    const Buffer<unsigned char> drawn(device(), 1, "no samples"), slots(device(), pixels.slots, "slots"),
        counts(device(), pixels.counts, "counts");
    const Buffer<int> first(device(), pixels.first_surfel, "first surfels");
    Buffer<float> image(device(), pixels.counts.size() * 3, "image");
    Buffer<float4> whole(device(), pixels.counts.size(), "pixels of one thing");
    const Buffer<float> nothing(device(), 1, "no background");
    std::vector<float> native_image(image.size());
    const native::FilmView view{pixels.slots.data(),
                                pixels.counts.data(),
                                pixels.first_surfel.data(),
                                table.weights.data(),
                                table.totals.data(),
                                table.reach,
                                samples,
                                side,
                                side};
    const double count = static_cast<double>(pixels.counts.size()), support = static_cast<double>(table.totals.size());
    // Of each neighbour its count, first surfel and rgb.
    compare(
        state,
        {product(pixels.counts.size(), "pixels", table.totals.size(), "neighbours"),
         count * support,
         count * (support * (1 + 4 + 12) + 12),
         {"resolve bench film"}},
        [&] {
            bench.kernels.get("whole_pixels")
                .args(device_values, 0, capacity, counts, first, side * side, nothing, 0, whole)
                .run(pixels.counts.size(), "resolve bench film");
            bench.kernels.get("resolve_film")
                .args(device_values, 0, capacity, whole, slots, counts, first, weights, totals, table.reach, samples, side, side, nothing,
                      0, device_values, drawn, 0, image)
                .run(pixels.counts.size(), "resolve bench film");
        },
        [&] { native::resolve_film(view, values.data(), static_cast<std::size_t>(capacity), native_image.data()); },
        [&] { return differences(image.read(), native_image, 1e-4, 0); });
}
BENCHMARK(bench_resolve_film)->Name("resolve_film")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
