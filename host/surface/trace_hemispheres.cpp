#include "surface/trace_hemispheres.h"

#include "pencils/low_discrepancy.h"

namespace pencil {

void trace_hemispheres(Kernels& kernels, const DeviceScene& scene, const SurfacePencils& pencils, int first, int count,
                       const TexelPoints& points, Surfels& surfels, int first_surfel) {
    const int texels = count * pencils.texels();
    surfels.count = first_surfel + texels;
    kernels.get("trace_hemispheres")
        .args(pencils.data, first, count, pencils.n, points.seed, sobol_2d(points.turn), scene.nodes, scene.leaves, scene.triangles,
              scene.planes, scene.materials, scene.normals, surfels.data, surfels.capacity, first_surfel)
        .run(kernels.packets(texels), "trace hemispheres");
}

}  // namespace pencil
