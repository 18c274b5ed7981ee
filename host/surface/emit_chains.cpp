#include "surface/emit_chains.h"

namespace pencil {

void emit_chains(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, Buffer<float>& radiance) {
    kernels.get("emit_chains")
        .args(surfels.list(), scene.materials, scene.environment(), radiance)
        .run(static_cast<std::size_t>(surfels.count), "emission");
}

}  // namespace pencil
