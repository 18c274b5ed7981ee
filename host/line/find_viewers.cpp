#include "line/find_viewers.h"

namespace pencil {

std::vector<int> find_viewers(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const Buffer<float4>& centres) {
    const int count = static_cast<int>(centres.size());
    Buffer<int> seen(kernels.device(), centres.size(), "surfels that see a pencil");
    kernels.get("find_viewers")
        .args(surfels.list(), centres, count, scene.hierarchy(), scene.faces(), seen)
        .run(centres.size(), "find pencils of a view");
    return seen.read();
}

}  // namespace pencil
