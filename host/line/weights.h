// Quadrature weights of pencils: how much the light of each counts at a surface point. The forms differ in what they need: a density in
// every texel (w of the radiance maps), or a table of directions. This file is the only one that knows which form needs what.
#pragma once

#include <map>
#include <string>
#include <tuple>

#include "cl/buffer.h"
#include "options/render_options.h"
#include "shared/types.h"

namespace pencil {

class Kernels;
struct DeviceScene;
struct PencilSet;
struct Surfels;
class FreeSpace;

/// Value of the define PENCIL_WEIGHTS.
int kernel_weights(Weights weights);
/// Whether texels of maps hold densities.
inline bool weights_in_maps(Weights weights) { return weights != Weights::voronoi; }
/// Whether these densities are made from visibility masks.
inline bool weights_need_masks(Weights weights) { return weights == Weights::dpdf || weights == Weights::thesis; }
/// One sentence for --explain.
std::string explain_weights(Weights weights, int grid);

/// Root of the number of directions that sample the Voronoi cells of so many pencils, a multiple of 4.
int cell_grid(int pencils);
/// The largest of a render whose first set has so many pencils. Takes few values: each is a build of the kernels.
int largest_cell_grid(int pencils);

/// Directions that sample Voronoi cells, CellDirections of kernels/lib/weights_voronoi.cl.
struct CellTable {
    /// Arguments `directions, direction_tiles` of kernels.
    auto list() const { return std::tie(directions, tiles); }

    Buffer<float4> directions;
    int tiles = 0;
};

/// What a form of weights needs beyond the pencils, made at the first use.
class WeightTables {
public:
    explicit WeightTables(Kernels& kernels) : kernels_(kernels) {}
    /// For a set of so many pencils; empty where the form needs none.
    const CellTable& cells(int pencils);

private:
    Kernels& kernels_;
    std::map<int, CellTable> cells_;  // by grid
};

}  // namespace pencil
