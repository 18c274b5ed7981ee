#include "surface/trace_hemispheres.h"

#include "pencils/low_discrepancy.h"

namespace pencil {

void trace_hemispheres(Kernels& kernels, const DeviceScene& scene, const SurfacePencils& pencils, int first, int count,
                       const TexelPoints& points, Surfels& surfels, int first_surfel, int map) {
    const int texels = count * pencils.texels();
    surfels.count = first_surfel + texels;
    kernels.get("trace_hemispheres")
        .args(pencils.data, first, count, pencils.texels(), map > 0 ? map : pencils.n, points.seed, sobol_2d(points.turn),
              scene.hierarchy(), scene.surfaces(), surfels.store(), first_surfel)
        .run(kernels.packets(texels), "trace hemispheres");
}

}  // namespace pencil
