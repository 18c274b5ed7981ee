#include "surface/sample_lights.h"

#include <algorithm>

namespace pencil {

namespace {

/// Lights of their own that a packet considers, if it does not consider all samples: more of them take turns.
constexpr int most_alone = 24;

}  // namespace

void sample_lights(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const LightSet& lights, int stride, int draws,
                   uint seed, Buffer<float>& outgoing) {
    kernels.get("sample_lights")
        .args(surfels.list(), lights.list(), scene.hierarchy(), scene.surfaces(),
              static_cast<float>(lights.maps.count) / static_cast<float>(draws), lights.alone,
              stride == 1 ? 1 : std::max(lights.alone / most_alone, 1), stride, draws, seed, outgoing)
        .run(kernels.packets(surfels.count), "direct light to surface pencils");
}

}  // namespace pencil
