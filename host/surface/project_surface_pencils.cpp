#include "surface/project_surface_pencils.h"

namespace pencil {

void project_surface_pencils(Kernels& kernels, const Surfels& surfels, const SurfacePencils& pencils, const DeviceGrid& grid,
                             Buffer<float>& outgoing) {
    kernels.get("project_surface_pencils")
        .args(surfels.list(), pencils.data, pencils.irradiance, grid.list(), outgoing)
        .run(static_cast<std::size_t>(surfels.count), "project surface pencils");
}

}  // namespace pencil
