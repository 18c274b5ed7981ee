#include "surface/smooth_irradiance.h"

namespace pencil {

void smooth_irradiance(Kernels& kernels, const PencilLattice& lattice, float most_error, int width, int height, Buffer<float4>& fits) {
    kernels.get("smooth_irradiance")
        .args(lattice.pencils.data, lattice.pencils.irradiance, lattice.at, most_error, width, height, fits)
        .run(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), "smooth irradiance");
}

}  // namespace pencil
