// Pencils on surfaces, in device memory, with the kernels that place, trace and sum them.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"
#include "device/surfels.h"
#include "shared/surface_pencil.h"

namespace pencil {

/// Pencils with their irradiance, and room for more; maps are not kept, only their sums.
struct SurfacePencils {
    SurfacePencils() = default;
    SurfacePencils(const std::shared_ptr<Device>& device, int room, int map_size)
        : n(map_size),
          data(device, static_cast<std::size_t>(room), "surface pencils"),
          irradiance(device, static_cast<std::size_t>(room), "irradiance of surface pencils") {}
    /// Makes room for `more` pencils behind the present ones.
    void reserve(const std::shared_ptr<Device>& device, std::size_t more);
    int texels() const { return n * n; }

    int count = 0;
    int n = 0;  // width of the hemispherical map, a multiple of 4 [texels]
    Buffer<SurfacePencil> data;
    Buffer<float4> irradiance;  // rgb [W m^-2], of pencils that were summed
};

/// The pencils of a set sorted into cells.
struct DeviceGrid {
    DeviceGrid() = default;
    DeviceGrid(const std::shared_ptr<Device>& device, const std::vector<SurfacePencil>& pencils, const FlatScene& flat);
    PencilGrid grid{};
    Buffer<int> starts;  // blocks of each cell
    Buffer<float> entries;
};

/// Surfels that pencils are placed on.
struct ChosenSurfels {
    /// `viewer`: where the surfel was seen from; `radius`: how far the pencil may be used through a grid [scene units].
    void add(int surfel, uint key, const glm::vec3& viewer, float radius = 0) {
        surfels.push_back(surfel);
        keys.push_back(key);
        views.emplace_back(viewer, radius);
    }
    std::vector<int> surfels;
    std::vector<uint> keys;     // SurfacePencil.key
    std::vector<float4> views;  // xyz: viewer; w: radius
};

/// Appends pencils; `spacing`: of the lattice of film pencils that they join [pixels].
void place_surface_pencils(Kernels& kernels, const Surfels& surfels, const ChosenSurfels& chosen, SurfacePencils& pencils, int spacing = 0);

/// Which points of their texels pencils see.
struct TexelPoints {
    uint seed = 0;
    uint turn = 0;  // points of one seed and key in successive turns fill each texel evenly
};

/// Surfels, from first_surfel on, that the texels of pencils first .. first + count see; surfels.count becomes the end of them.
void trace_hemispheres(Kernels& kernels, const DeviceScene& scene, const SurfacePencils& pencils, int first, int count,
                       const TexelPoints& points, Surfels& surfels, int first_surfel = 0);

/// Harmonic mean distance and horizon of pencils first .. first + count from what their texels see.
void measure_hemispheres(Kernels& kernels, const Surfels& surfels, int first_surfel, int first, int count, SurfacePencils& pencils);

/// Adds emission that pencils first .. see, of emitters near them in terms of near_area[material] (near_areas).
void emit_hemispheres(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const SurfacePencils& pencils, int first,
                      const Buffer<float>& near_area, Buffer<float>& radiance);

/// irradiance[first .. first + count] of pencils of n x n texels from what these send.
void sum_hemispheres(Kernels& kernels, const Buffer<float>& radiance, int capacity, int first_surfel, int first, int count, int n,
                     Buffer<float4>& irradiance);

/// The pencils near each surfel and their weights.
struct SurfaceLinks {
    Buffer<glm::ivec4> pencils;  // -1: none
    Buffer<float4> weights;
};
SurfaceLinks link_surfels(Kernels& kernels, const Surfels& surfels, const SurfacePencils& pencils, const DeviceGrid& grid);

/// Adds reflected irradiance of the pencils near each surfel.
void project_surface_pencils(Kernels& kernels, const Surfels& surfels, const SurfacePencils& pencils, const DeviceGrid& grid,
                             Buffer<float>& outgoing);

}  // namespace pencil
