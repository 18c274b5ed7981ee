#include "surface/link_surfels.h"

namespace pencil {

SurfaceLinks link_surfels(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const SurfacePencils& pencils,
                          const DeviceGrid& grid) {
    const auto count = static_cast<std::size_t>(surfels.count);
    SurfaceLinks links{Buffer<glm::ivec4>(kernels.device(), count, "links of surfels"),
                       Buffer<float4>(kernels.device(), count, "link weights of surfels")};
    kernels.get("link_surfels")
        .args(surfels.list(), pencils.data, grid.list(), scene.hierarchy(), scene.faces(), links.list())
        .run(count, "link surfels");
    return links;
}

}  // namespace pencil
