#include <algorithm>

#include "bench/native/near_pencils.h"
#include "bench/native/parallel.h"
#include "bench/native/surface.h"

namespace pencil::native {

int grid_lanes() { return lane_count; }

void link_surfels(const SurfelsView& surfels, const SurfacePencil* pencils, const GridView& grid, glm::ivec4* links, float4* weights) {
    parallel_blocks(
        surfels.count, 256,
        [&](int first, int last) {
            for (int i = first; i < last; ++i) {
                NearPencils near;
                const Vec3 albedo = vector_at(surfels, SURFEL_ALBEDO_R, i);
                if (int_at(surfels, SURFEL_PLANE, i) >= 0 && std::max({albedo.x, albedo.y, albedo.z}) > 0.0F)
                    near = near_pencils(pencils, grid, vector_at(surfels, SURFEL_X, i), vector_at(surfels, SURFEL_NX, i));
                links[i] = {near.index[0], near.index[1], near.index[2], near.index[3]};
                weights[i] = {near.weight[0], near.weight[1], near.weight[2], near.weight[3]};
            }
        });
}

}  // namespace pencil::native
