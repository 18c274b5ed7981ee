// The native loops of the surface method's kernels, each in a file of the kernel's name. Plain scalar loops over all cores where the kernel
// is scalar, vectors where it works in packets.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "bench/native/views.h"
#include "shared/bvh.h"
#include "shared/surface_pencil.h"

namespace pencil::native {

struct BvhView {
    const BvhNode* nodes = nullptr;
    const int* leaves = nullptr;
};

/// The grid of a set of pencils: cell c has blocks starts[c] .. starts[c + 1] of `entries`, ENTRY_FIELDS x grid_lanes() each.
struct GridView {
    PencilGrid grid;
    const int* starts = nullptr;
    const float* entries = nullptr;
};

/// Surfels of the film by pixel, and pencils by pixel on the lattice of spacings coarsest .. finest.
struct LatticeView {
    SurfelsView surfels;
    const unsigned char* counts = nullptr;
    const int* first = nullptr;
    const SurfacePencil* pencils = nullptr;
    const int* at = nullptr;
    int coarsest = 0, finest = 0, width = 0, height = 0;
};

/// Entries of a block of the grid: the width of the native loops' vectors.
int grid_lanes();

/// Pencils on surfels chosen[0 .. count), as kernels/place_surface_pencils.cl.
void place_surface_pencils(const SurfelsView& surfels, const int* chosen, const uint* keys, const float4* views, int count, int spacing,
                           SurfacePencil* pencils);

/// Surfels that n x n texels of `count` pencils see, for scenes without vertex normals; `shift`: of all points, fractions of 2^32.
void trace_hemispheres(const SceneView& scene, const BvhView& bvh, const SurfacePencil* pencils, int count, int n, uint seed,
                       const glm::uvec2& shift, float* surfels, std::size_t capacity);

/// Harmonic mean distance and horizon of `count` pencils whose texels are `surfels`.
void measure_hemispheres(const SurfelsView& surfels, int count, int n, SurfacePencil* pencils);

/// Adds the share of emission that texels see.
void emit_hemispheres(const SceneView& scene, const SurfelsView& surfels, const SurfacePencil* pencils, int n, const float* near_area,
                      RgbView radiance);

/// pi / n^2 times the sum over texels.
void sum_hemispheres(RgbView radiance, int count, int n, float4* irradiance);

/// Pencils near each surfel and their weights.
void link_surfels(const SurfelsView& surfels, const SurfacePencil* pencils, const GridView& grid, glm::ivec4* links, float4* weights);

/// Adds the reflected irradiance of the pencils near each surfel.
void project_surface_pencils(const SurfelsView& surfels, const SurfacePencil* pencils, const float4* irradiance, const GridView& grid,
                             RgbView outgoing);

/// Adds the reflected irradiance of `count` pencils on chosen surfels, as often as `counts` says.
void project_contacts(const SurfelsView& surfels, const int* chosen, const float* counts, int count, const float4* irradiance,
                      RgbView outgoing);

/// One bounce of `count` pencils of n x n texels.
void transport_irradiance(const SurfelsView& surfels, const glm::ivec4* links, const float4* weights, int count, int n,
                          const float4* source, float4* target, float4* total);

/// total += tail * last.
void close_series(const float4* last, const float4& tail, int count, float4* total);

/// Harmonic mean distance of the emitters that pencils see, by the share of their light that light samples leave.
void approach_emitters(const SceneView& scene, const SurfelsView& surfels, int count, int n, const float* near_area,
                       SurfacePencil* pencils);

/// reaches: by pencil, at most the distance of emitters from neighbours at `spacing`.
void limit_reuse(const LatticeView& film, int spacing, float* reaches);

/// 1 where the surfels in question are not covered, else 0.
void cover_film(const LatticeView& film, float most_error, unsigned char* uncovered);

/// Three values per pencil: irradiance and its slopes.
void smooth_irradiance(const LatticeView& film, const float4* irradiance, float most_error, float4* fits);

/// Adds reflected irradiance to the film's surfels; single_at: by surfel, -1: none.
void project_film_pencils(const LatticeView& film, const float4* fits, float most_error, const float4* single_irradiance,
                          const int* single_at, RgbView outgoing);

/// Adds direct light by drawn samples; packets of `width` surfels draw together.
void sample_lights(const SceneView& scene, const BvhView& bvh, const SurfelsView& surfels, const LightSample* samples, int sample_count,
                   int width, int stride, int draws, uint seed, RgbView outgoing);

}  // namespace pencil::native
