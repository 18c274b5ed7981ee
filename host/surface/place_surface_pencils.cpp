#include "surface/place_surface_pencils.h"

namespace pencil {

void place_surface_pencils(Kernels& kernels, const Surfels& surfels, const ChosenSurfels& chosen, SurfacePencils& pencils, int spacing) {
    const std::size_t count = chosen.surfels.size();
    if (count == 0) return;
    pencils.reserve(kernels.device(), count);
    const Buffer<int> ids(kernels.device(), chosen.surfels, "chosen surfels");
    const Buffer<uint> keys(kernels.device(), chosen.keys, "keys of chosen surfels");
    const Buffer<float4> views(kernels.device(), chosen.views, "views of chosen surfels");
    kernels.get("place_surface_pencils")
        .args(surfels.store(), ids, keys, views, static_cast<int>(count), spacing, pencils.count, pencils.data)
        .run(count, "place surface pencils");
    pencils.count += static_cast<int>(count);
}

}  // namespace pencil
