#include "surface/sample_lights.h"

#include <algorithm>

namespace pencil {

namespace {

/// Lights of their own that these consider, if it does not consider all samples: more of them take turns.
constexpr int most_alone = 24;

}  // namespace

void sample_lights(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const LightSet& lights, int stride, int draws,
                   uint seed, Buffer<float>& outgoing, const std::optional<Viewers>& viewers) {
    const ViewerArguments seen_by(kernels.device(), viewers);
    kernels.get("sample_lights")
        .args(surfels.list(), seen_by.list(), lights.list(), scene.hierarchy(), scene.surfaces(),
              static_cast<float>(lights.maps.count) / static_cast<float>(draws), lights.alone,
              stride == 1 ? 1 : std::max(lights.alone / most_alone, 1), stride, draws, seed, outgoing)
        .run(static_cast<std::size_t>((surfels.count + LIGHT_SURFELS - 1) / LIGHT_SURFELS), "direct light to surface pencils");
}

}  // namespace pencil
