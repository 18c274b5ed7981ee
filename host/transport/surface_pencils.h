// Pencils on surfaces, in device memory, with the kernels that place, trace and sum them.
#pragma once

#include "pencils/build_bvh.h"
#include "shared/surface_pencil.h"
#include "transport/device_scene.h"
#include "transport/features.h"
#include "transport/pencil_set.h"
#include "transport/surfels.h"

namespace pencil {

/// The hierarchy of the scene's triangles in device memory.
struct DeviceBvh {
    DeviceBvh(const std::shared_ptr<Device>& device, const Bvh& bvh)
        : nodes(device, bvh.nodes, "hierarchy"), leaves(device, bvh.leaves, "leaves of the hierarchy") {}
    Buffer<BvhNode> nodes;
    Buffer<int> leaves;
};

/// Pencils and room for more; maps are not kept, only their sums.
struct SurfacePencils {
    SurfacePencils() = default;
    SurfacePencils(const std::shared_ptr<Device>& device, int room, int map_size)
        : n(map_size), data(device, static_cast<std::size_t>(room), "surface pencils") {}
    /// Makes room for `more` pencils behind the present ones.
    void reserve(const std::shared_ptr<Device>& device, std::size_t more);
    int texels() const { return n * n; }

    int count = 0;
    int n = 0;  // width of the hemispherical map, a multiple of 4 [texels]
    Buffer<SurfacePencil> data;
};

/// The pencils of a set sorted into cells.
struct DeviceGrid {
    DeviceGrid() = default;
    DeviceGrid(const std::shared_ptr<Device>& device, const std::vector<SurfacePencil>& pencils, const FlatScene& flat);
    PencilGrid grid{};
    Buffer<int> starts, entries;
};

/// Appends pencils on the chosen surfels; `radius` [scene units] is how far they may be used through a grid.
void place_surface_pencils(Kernels& kernels, const Surfels& surfels, const std::vector<int>& chosen, float radius, SurfacePencils& pencils,
                           float spacing = 0);

/// Surfels and distances [scene units] that the texels of pencils first .. first + count see.
void trace_hemispheres(Kernels& kernels, const DeviceScene& scene, const DeviceBvh& bvh, const SurfacePencils& pencils, int first,
                       int count, uint seed, Surfels& surfels, Buffer<float>& distances);

/// Irradiance, harmonic mean distance and horizon of pencils first .. first + count from what their texels send.
void sum_hemispheres(Kernels& kernels, const Buffer<float>& radiance, const Buffer<float>& distances, int capacity, int first, int count,
                     SurfacePencils& pencils);

/// Adds reflected irradiance of the pencils near each surfel.
void project_surface_pencils(Kernels& kernels, const Surfels& surfels, const SurfacePencils& pencils, const DeviceGrid& grid,
                             Buffer<float>& outgoing);

}  // namespace pencil
