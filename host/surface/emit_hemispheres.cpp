#include "surface/emit_hemispheres.h"

namespace pencil {

void emit_hemispheres(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const Viewers& viewers,
                      const Buffer<float>& near_area, Buffer<float>& radiance) {
    kernels.get("emit_hemispheres")
        .args(surfels.list(), viewers.pencils.data, viewers.first, viewers.rays_each(), scene.materials, near_area, scene.environment(),
              radiance)
        .run(static_cast<std::size_t>(surfels.count), "emission");
}

}  // namespace pencil
