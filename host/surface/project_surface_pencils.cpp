#include "surface/project_surface_pencils.h"

namespace pencil {

void project_surface_pencils(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const SurfacePencils& pencils,
                             const Buffer<float4>& irradiance, const DeviceGrid& grid, const Viewers& viewers, float nearness,
                             Buffer<float>& outgoing, Buffer<unsigned char>& contact) {
    kernels.get("project_surface_pencils")
        .args(surfels.list(), pencils.data, irradiance, grid.list(), scene.hierarchy(), scene.faces(), viewers.pencils.data, viewers.first,
              viewers.rays_each(), nearness, outgoing, contact)
        .run(static_cast<std::size_t>(surfels.count), "project surface pencils");
}

}  // namespace pencil
