// The best native C++ loops that we know for the work of the kernels, on all cores. Each does what the kernel of its name does and is
// organised as suits a CPU best; compiled with -O3 -march=native, each in a file of its own.
#pragma once

#include <vector>

#include "bench/native/views.h"

namespace pencil::native {

/// sum[i] = sum over the tiles t of the bilinear texel of `radiance` in direction x_i - cops[t]; x: three arrays of `count`, a multiple of
/// 16.
void octahedral_lookup(const float* x, const float* y, const float* z, int count, const MapsView& maps, const float4* radiance,
                       float4* sum);

/// Interior texels of hits, atlas layout.
void rasterize_octahedral(const SceneView& scene, const float4* cops, int count, int n, Hit* hits);

/// Gutters of hits, and cells and groups of every footprint.
void fold_hits(const SceneView& scene, const float4* cops, int count, int n, Hit* hits, glm::ivec2* cells, glm::ivec4* groups);

/// mask[word][capacity], as kernels/test_visibility.cl.
void test_visibility(const SceneView& scene, const SurfelsView& surfels, const MapsView& maps, uint* mask);

/// 1/D of the texels of tiles first_tile .. into the w of radiance.
void estimate_density(const SurfelsView& surfels, const float4* cops, int count, const uint* mask, int first_tile, int n, float4* radiance);

/// Adds reflected direct light.
void light_surfels(const SceneView& scene, const SurfelsView& surfels, const LightSample* samples, const MapsView& maps, RgbView outgoing);

/// Adds reflected radiance of pencils; visible[i]: pencils that surfel i sees.
void project_pencils(const SceneView& scene, const SurfelsView& surfels, const MapsView& maps, const float4* radiance, RgbView outgoing,
                     int* visible);

/// Surfels of tiles first .. first + count, as kernels/gather_surfels.cl for scenes without vertex normals.
void gather_surfels(const SceneView& scene, const MapsView& maps, int first, int count, float* surfels, std::size_t capacity);

/// Adds emitted radiance of all emitters.
void emit_surfels(const SceneView& scene, const SurfelsView& surfels, RgbView radiance);

/// Outgoing radiance of the surfels of `count` tiles of n x n into radiance maps, smoothed, gutters filled (store_radiance and
/// smooth_radiance).
void store_radiance(const float* outgoing, std::size_t capacity, int count, int n, float4* radiance);

/// means[tile]: mean of the interior texels.
void sum_radiance(const float4* radiance, int count, int n, float4* means);

/// hits[sample][row][x] of rows first_row .. of the film.
void rasterize_film(const SceneView& scene, const Camera& camera, const float4* to_film, const std::vector<glm::vec2>& offsets,
                    int first_row, int rows, Hit* hits);

/// What resolve_film reads of a film.
struct FilmView {
    const unsigned char* slots = nullptr;
    const unsigned char* counts = nullptr;
    const int* first_surfel = nullptr;
    const float* weights = nullptr;
    const float* totals = nullptr;
    int reach = 0, samples = 0, width = 0, height = 0;
};

/// Pixels (rgb) of values[3][capacity].
void resolve_film(const FilmView& film, const float* values, std::size_t capacity, float* image);

}  // namespace pencil::native
