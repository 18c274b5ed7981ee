#include "film/emit_surfels.h"

namespace pencil {

void emit_surfels(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, bool carried_only, Buffer<float>& radiance) {
    kernels.get("emit_surfels")
        .args(surfels.list(), scene.materials, carried_only ? 1 : 0, radiance)
        .run(static_cast<std::size_t>(surfels.count), "emission");
}

}  // namespace pencil
