// Film hits for the benchmarks of film kernels: the product's Film keeps them to itself, so these are the same launches by hand.
#pragma once

#include "bench/workbench.h"
#include "pencils/film_filter.h"

namespace pencil::bench {

struct FilmBench {
    FilmBench()
        : offsets(film_sample_offsets(sizes().film_samples, 0)),
          device_offsets(device(), offsets, "film sample offsets"),
          hits(device(), static_cast<std::size_t>(sizes().film) * static_cast<std::size_t>(sizes().film) * offsets.size(), "film hits"),
          native_hits(hits.size()) {}

    void rasterize_native() {
        const Workbench& bench = workbench();
        native::rasterize_film(bench.view(), bench.flat.camera, bench.flat.to_film.data(), offsets, 0, sizes().film, native_hits.data());
    }

    std::vector<glm::vec2> offsets;
    Buffer<glm::vec2> device_offsets;
    Buffer<Hit> hits;
    std::vector<Hit> native_hits;
};

}  // namespace pencil::bench
