#include "surface/measure_hemispheres.h"

namespace pencil {

void measure_hemispheres(Kernels& kernels, const Surfels& surfels, int first_surfel, int first, int count, SurfacePencils& pencils) {
    kernels.get("measure_hemispheres")
        .args(surfels.store(), first_surfel, first, count, pencils.n, pencils.data)
        .run(static_cast<std::size_t>(count), "measure hemispheres", pencil_group);
}

}  // namespace pencil
