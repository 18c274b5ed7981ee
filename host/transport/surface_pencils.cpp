#include "transport/surface_pencils.h"

#include <algorithm>
#include <cmath>

namespace pencil {

namespace {

/// Cells along the longest axis of the grid at most.
constexpr double most_cells = 64;

glm::ivec3 cell_of(const PencilGrid& grid, const glm::vec3& p) {
    const glm::ivec3 cell((p - glm::vec3(grid.low)) * grid.low.w);
    return glm::clamp(cell, glm::ivec3(0), glm::ivec3(grid.size_x, grid.size_y, grid.size_z) - 1);
}

/// Calls visit(cell index) for the cells that a pencil's radius reaches.
template <typename Visit>
void for_cells(const PencilGrid& grid, const SurfacePencil& pencil, Visit visit) {
    const glm::vec3 radius(pencil.normal.w), at(pencil.position);
    const glm::ivec3 low = cell_of(grid, at - radius), high = cell_of(grid, at + radius);
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) visit(static_cast<std::size_t>((z * grid.size_y + y) * grid.size_x + x));
}

}  // namespace

DeviceGrid::DeviceGrid(const std::shared_ptr<Device>& device, const std::vector<SurfacePencil>& pencils, const FlatScene& flat) {
    const glm::vec3 extent(flat.high - flat.low);
    float size = std::max({extent.x, extent.y, extent.z}) / static_cast<float>(most_cells);
    for (const SurfacePencil& p : pencils) size = std::max(size, 0.5F * p.normal.w);
    grid.low = float4(glm::vec3(flat.low), 1.0F / size);
    const glm::ivec3 cells = glm::ivec3(extent / size) + 1;
    grid.size_x = cells.x;
    grid.size_y = cells.y;
    grid.size_z = cells.z;
    std::vector<int> start(static_cast<std::size_t>(cells.x * cells.y * cells.z) + 1, 0);
    for (const SurfacePencil& p : pencils) for_cells(grid, p, [&](std::size_t cell) { ++start[cell + 1]; });
    for (std::size_t c = 1; c < start.size(); ++c) start[c] += start[c - 1];
    std::vector<int> entry(static_cast<std::size_t>(start.back())), next(start.begin(), start.end() - 1);
    for (std::size_t i = 0; i < pencils.size(); ++i)
        for_cells(grid, pencils[i], [&](std::size_t cell) { entry[static_cast<std::size_t>(next[cell]++)] = static_cast<int>(i); });
    starts = Buffer<int>(device, start, "grid of surface pencils");
    entries = Buffer<int>(device, entry, "entries of the grid");
}

void SurfacePencils::reserve(const std::shared_ptr<Device>& device, std::size_t more) {
    const std::size_t needed = static_cast<std::size_t>(count) + more;
    if (needed <= data.size()) return;
    Buffer<SurfacePencil> larger(device, std::max(needed, 2 * data.size()), "surface pencils");
    if (count > 0) larger.copy_from(data, 0, 0, static_cast<std::size_t>(count));
    data = std::move(larger);
}

void place_surface_pencils(Kernels& kernels, const Surfels& surfels, const std::vector<int>& chosen, float radius, SurfacePencils& pencils,
                           float spacing) {
    if (chosen.empty()) return;
    pencils.reserve(kernels.device(), chosen.size());
    const Buffer<int> ids(kernels.device(), chosen, "chosen surfels");
    const int count = static_cast<int>(chosen.size());
    kernels.get("place_surface_pencils")
        .args(surfels.data, surfels.capacity, ids, count, radius, spacing, pencils.count, pencils.data)
        .run(chosen.size(), "place surface pencils");
    pencils.count += count;
}

void trace_hemispheres(Kernels& kernels, const DeviceScene& scene, const DeviceBvh& bvh, const SurfacePencils& pencils, int first,
                       int count, uint seed, Surfels& surfels, Buffer<float>& distances) {
    surfels.count = count * pencils.texels();
    kernels.get("trace_hemispheres")
        .args(pencils.data, first, count, pencils.n, seed, bvh.nodes, bvh.leaves, scene.triangles, scene.planes, scene.materials,
              scene.normals, surfels.data, surfels.capacity, distances)
        .run(kernels.packets(surfels.count), "trace hemispheres");
}

void sum_hemispheres(Kernels& kernels, const Buffer<float>& radiance, const Buffer<float>& distances, int capacity, int first, int count,
                     SurfacePencils& pencils) {
    kernels.get("sum_hemispheres")
        .args(radiance, distances, capacity, first, count, pencils.n, pencils.data)
        .run(static_cast<std::size_t>(count), "sum hemispheres", 8);
}

void project_surface_pencils(Kernels& kernels, const Surfels& surfels, const SurfacePencils& pencils, const DeviceGrid& grid,
                             Buffer<float>& outgoing) {
    kernels.get("project_surface_pencils")
        .args(surfels.data, surfels.capacity, surfels.count, pencils.data, grid.grid, grid.starts, grid.entries, outgoing)
        .run(static_cast<std::size_t>(surfels.count), "project surface pencils");
}

}  // namespace pencil
