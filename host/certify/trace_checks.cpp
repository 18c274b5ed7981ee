#include "certify/trace_checks.h"

namespace pencil {

void trace_checks(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const Buffer<int>& starts, const CheckLights& lights,
                  int orders, uint seed, Buffer<float>& radiance) {
    const int paths = static_cast<int>(starts.size());
    kernels.get("trace_checks")
        .args(surfels.store(), starts, paths, lights.list(), scene.environment(), orders, seed, scene.hierarchy(), scene.surfaces(),
              radiance)
        .run(kernels.packets(paths), "check paths");
}

}  // namespace pencil
