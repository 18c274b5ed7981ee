// Quadrature weights of pencils: how much the light of each counts at a surface point. The forms differ in what they need: a density in
// every texel (w of the radiance maps), or a table of directions. This file is the only one that knows which form needs what.
#pragma once

#include <map>
#include <string>
#include <tuple>

#include "cl/buffer.h"
#include "device/radiance_atlas.h"
#include "options/render_options.h"
#include "shared/types.h"
#include "shared/weights.h"

namespace pencil {

class Kernels;
struct DeviceScene;
struct PencilSet;
struct Surfels;
class FreeSpace;

/// Value of the define PENCIL_WEIGHTS, which is Features::weights.
int kernel_weights(Weights weights);
int kernel_weights(const RenderOptions& options);
/// Whether they are cells of directions, which are sampled.
inline bool weights_are_cells(int form) { return form == PENCIL_WEIGHTS_VORONOI || form == PENCIL_WEIGHTS_POWER; }
/// Whether texels of maps hold densities.
inline bool weights_in_maps(int form) { return form != PENCIL_WEIGHTS_VORONOI; }
/// Whether these densities are made from visibility masks.
inline bool weights_need_masks(int form) { return form == PENCIL_WEIGHTS_DPDF || form == PENCIL_WEIGHTS_THESIS; }
/// Whether they hold for centres spread evenly alone.
inline bool weights_need_even_centres(int form) { return form == PENCIL_WEIGHTS_ANALYTIC || form == PENCIL_WEIGHTS_POWER; }
/// Whether surfels send rays of their own beside.
inline bool weights_need_rays(int form) { return form == PENCIL_WEIGHTS_POWER; }
/// One sentence for --explain.
std::string explain_weights(int form, int grid);

/// Root of the number of directions that sample the cells of so many pencils and rays, a multiple of 4, PENCIL_CELL_LARGEST_GRID at most.
int cell_grid(int sites);
/// The largest of a render whose first set has so many pencils and rays. Takes few values: each is a build of the kernels.
int largest_cell_grid(int sites);

/// Directions that sample cells, CellDirections of kernels/lib/cells.cl.
struct CellTable {
    /// Arguments `directions, direction_tiles` of kernels.
    auto list() const { return std::tie(directions, tiles); }

    Buffer<float4> directions;
    int tiles = 0;
};

/// What the rays of a stretch of surfels have found (kernels/shared/weights.h, RAY_FIELDS).
struct SurfelRays {
    /// Arguments `rays, ray_capacity, ray_count, volume` of kernels.
    auto list() const { return std::tie(data, capacity, count, volume); }

    Buffer<float> data;
    int capacity = 0;  // surfels
    int count = 0;     // rays of each
    float volume = 0;  // in which the pencils' centres are uniform [normalised scene units]
};

/// What a form of weights needs beyond the pencils, made at the first use.
class WeightTables {
public:
    explicit WeightTables(Kernels& kernels);
    /// For so many pencils and rays of a surfel; empty where the form needs none.
    const CellTable& cells(int sites);
    /// Of surfels that are projected to next; empty where the form sends no rays.
    SurfelRays& rays() { return rays_; }
    /// Where radiance maps are looked up as an image.
    RadianceAtlas& atlas() { return atlas_; }

private:
    Kernels& kernels_;
    SurfelRays rays_;
    RadianceAtlas atlas_;
    std::map<int, CellTable> cells_;  // by grid
};

}  // namespace pencil
