#include "surface/approach_emitters.h"

namespace pencil {

void approach_emitters(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, int first, int count,
                       const Buffer<float>& near_area, SurfacePencils& pencils) {
    kernels.get("approach_emitters")
        .args(surfels.store(), first, count, pencils.n, scene.materials, near_area, pencils.data)
        .run(static_cast<std::size_t>(count), "approach emitters", pencil_group);
}

}  // namespace pencil
