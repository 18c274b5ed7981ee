#include "surface/limit_reuse.h"

namespace pencil {

void limit_reuse(Kernels& kernels, SurfacePencils& pencils, const Buffer<int>& pencil_at, int spacing, int first_new, int width,
                 int height) {
    kernels.get("limit_reuse")
        .args(pencils.data, pencil_at, spacing, first_new, width, height)
        .run(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), "limit reuse");
}

}  // namespace pencil
