#include "surface/guide_hemispheres.h"

#include "pencils/low_discrepancy.h"

namespace pencil {

void guide_hemispheres(Kernels& kernels, const DeviceScene& scene, const SurfacePencils& pencils, int first, int count,
                       const DeviceSpots& spots, const TexelPoints& points, Surfels& surfels, Buffer<float>& factors, Keys keys) {
    surfels.count = count * SPOT_RAYS;
    kernels.get("guide_hemispheres")
        .args(pencils.data, first, count, pencils.texels(), keys == Keys::shared ? 1 : 0, spots.list(), points.seed, sobol_2d(points.turn),
              scene.hierarchy(), scene.surfaces(), surfels.store(), factors)
        .run(kernels.packets(surfels.count), "guide hemispheres");
}

}  // namespace pencil
