#include "surface/emit_hemispheres.h"

namespace pencil {

void emit_hemispheres(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const SurfacePencils& pencils, int first,
                      const Buffer<float>& near_area, Buffer<float>& radiance) {
    kernels.get("emit_hemispheres")
        .args(surfels.list(), pencils.data, first, pencils.n, scene.materials, near_area, scene.environment(), radiance)
        .run(static_cast<std::size_t>(surfels.count), "emission");
}

}  // namespace pencil
