#include "line/weights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "device/features.h"
#include "pencils/cell_directions.h"

namespace pencil {

int kernel_weights(Weights weights) {
    switch (weights) {
        case Weights::voronoi:
            return PENCIL_WEIGHTS_VORONOI;
        case Weights::analytic:
            return PENCIL_WEIGHTS_ANALYTIC;
        case Weights::thesis:
            return PENCIL_WEIGHTS_THESIS;
        case Weights::dpdf:
            break;
    }
    return PENCIL_WEIGHTS_DPDF;
}

int kernel_weights(const RenderOptions& options) {
    return options.method == MethodName::hybrid ? PENCIL_WEIGHTS_POWER : kernel_weights(options.weights);
}

std::string explain_weights(int form, int grid) {
    switch (form) {
        case PENCIL_WEIGHTS_VORONOI:
            return fmt::format(
                "weights: Voronoi cells of the visible directions, sampled by {} directions; left out: visibility masks and density",
                grid * grid);
        case PENCIL_WEIGHTS_ANALYTIC:
            return "weights: self-normalised 1/p, p from the free path and the free volume; left out: visibility masks";
        case PENCIL_WEIGHTS_POWER:
            return fmt::format(
                "weights: power cells of the directions of pencils and of rays of the surfels, sampled by {} directions; left out: "
                "visibility masks",
                grid * grid);
        case PENCIL_WEIGHTS_THESIS:
            return "weights: the printed normaliser of eq. (5.33), which is not consistent";
        default:
            break;
    }
    return "weights: self-normalised 1/D, beta from the number of visible pencils";
}

int cell_grid(int sites) {
    constexpr int width = 4, smallest = 8;
    const double root = std::sqrt(static_cast<double>(PENCIL_CELL_DIRECTIONS) * sites);
    return std::clamp(width * static_cast<int>(std::ceil(root / width)), smallest, PENCIL_CELL_LARGEST_GRID);
}

int largest_cell_grid(int sites) {
    const int grid = cell_grid(sites);
    return grid <= PENCIL_CELL_LARGEST_GRID / 2 ? PENCIL_CELL_LARGEST_GRID / 2 : PENCIL_CELL_LARGEST_GRID;
}

WeightTables::WeightTables(Kernels& kernels) : kernels_(kernels), atlas_(kernels.device()) {
    rays_.data = Buffer<float>(kernels.device(), std::vector<float>(), "light of rays");
}

const CellTable& WeightTables::cells(int sites) {
    const bool cells = weights_are_cells(kernels_.features().weights);
    const int grid = cells ? std::min(cell_grid(sites), kernels_.features().cell_grid) : 0;
    CellTable& table = cells_[grid];
    if (!table.directions.allocated()) {
        table.directions = Buffer<float4>(kernels_.device(), cells ? cell_directions(grid) : std::vector<float4>(), "cell directions");
        table.tiles = grid * grid / PENCIL_CELL_TILE;
    }
    return table;
}

}  // namespace pencil
