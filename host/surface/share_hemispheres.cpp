#include "surface/share_hemispheres.h"

#include "pencils/low_discrepancy.h"

namespace pencil {

void share_hemispheres(Kernels& kernels, const SurfacePencils& pencils, int first, int count, const DeviceSpots& spots,
                       const TexelPoints& points, Buffer<float>& radiance, int capacity, int map) {
    kernels.get("share_hemispheres")
        .args(pencils.data, first, count, pencils.texels(), map > 0 ? map : pencils.n, points.seed, sobol_2d(points.turn), spots.list(),
              radiance, capacity)
        .run(static_cast<std::size_t>(count), "share hemispheres", pencil_group);
}

}  // namespace pencil
