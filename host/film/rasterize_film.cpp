#include "film/rasterize_film.h"

#include <algorithm>
#include <tuple>

namespace pencil {

namespace {

/// Rows per work-item, at least. Every band looks at every triangle, so their number is bounded.
constexpr int band_rows = 8;
constexpr int most_bands = 256;

}  // namespace

void rasterize_film(Kernels& kernels, const DeviceScene& scene, const Camera& camera, const Buffer<glm::vec2>& offsets, int samples,
                    int first_row, int rows, Buffer<Hit>& hits, const std::string& what) {
    const auto count = static_cast<std::size_t>(scene.triangle_count);
    Buffer<float4> bounds(kernels.device(), std::max<std::size_t>(count, 1), "bounds of triangles on the film");
    kernels.get("bound_film").args(scene.all_triangles(), camera, scene.to_film, bounds).run(count, what);
    const int band = std::max(band_rows, (rows + most_bands - 1) / most_bands), bands = (rows + band - 1) / band;
    kernels.get("rasterize_film")
        .args(scene.all_triangles(), camera, bounds, offsets, samples, std::make_tuple(first_row, rows, band), hits)
        .run(static_cast<std::size_t>(bands) * static_cast<std::size_t>(samples), what);
}

}  // namespace pencil
