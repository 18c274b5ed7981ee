#include "transport/weights.h"

#include <algorithm>
#include <array>

#include "pencils/cell_directions.h"
#include "shared/weights.h"
#include "transport/features.h"

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

std::string weights_library(Weights weights) { return weights == Weights::voronoi ? "weights_voronoi" : "weights_density"; }

std::string explain_weights(Weights weights, int grid) {
    switch (weights) {
        case Weights::voronoi:
            return "weights: Voronoi cells of the visible directions, sampled by " + std::to_string(grid * grid) +
                   " directions; left out: visibility masks and density";
        case Weights::analytic:
            return "weights: self-normalised 1/p, p from the free path and the free volume; left out: visibility masks";
        case Weights::thesis:
            return "weights: the printed normaliser of eq. (5.33), which is not consistent";
        case Weights::dpdf:
            break;
    }
    return "weights: self-normalised 1/D, beta from the number of visible pencils";
}

int cell_grid(int pencils) {
    constexpr std::array<int, 4> grids{16, 24, 32, 48};  // few, as each is a build of the kernels
    constexpr int directions_per_pencil = 4;
    for (const int grid : grids)
        if (grid * grid >= directions_per_pencil * pencils) return grid;
    return grids.back();
}

WeightTable::WeightTable(Kernels& kernels) {
    const Features& features = kernels.features();
    directions = Buffer<float4>(kernels.device(),
                                features.cell_grid > 0 ? cell_directions(features.cell_grid) : std::vector<float4>(), "cell directions");
}

}  // namespace pencil
