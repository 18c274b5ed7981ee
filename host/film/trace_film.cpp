#include "film/trace_film.h"

namespace pencil {

namespace {

/// Triangles for each column of the film from which on rays are faster, a rule from docs/performance.md.
constexpr int triangles_per_column = 400;

}  // namespace

void trace_film(Kernels& kernels, const DeviceScene& scene, const Camera& camera, const Buffer<glm::vec2>& offsets, int samples,
                int first_row, int rows, Buffer<Hit>& hits, const std::string& what) {
    kernels.get("trace_film")
        .args(scene.hierarchy(), scene.faces(), camera, offsets, samples, first_row, rows, hits)
        .run(kernels.packets(rows * camera.width * samples), what);
}

bool film_is_traced(const DeviceScene& scene, const Camera& camera) {
    return scene.has_bvh && scene.triangle_count / triangles_per_column > camera.width;
}

}  // namespace pencil
