#include "surface/sample_lights.h"

namespace pencil {

void sample_lights(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const LightSet& lights, int stride, int draws,
                   uint seed, Buffer<float>& outgoing) {
    kernels.get("sample_lights")
        .args(surfels.list(), lights.list(), scene.faces(), scene.hierarchy(), stride, draws, seed, outgoing)
        .run(kernels.packets(surfels.count), "direct light to surface pencils");
}

}  // namespace pencil
