#include "bench/native/near_pencils.h"
#include "bench/native/parallel.h"
#include "bench/native/surface.h"

namespace pencil::native {

void project_surface_pencils(const SurfelsView& surfels, const SurfacePencil* pencils, const float4* irradiance, const GridView& grid,
                             RgbView outgoing) {
    constexpr float inverse_pi = 0.318309886F;
    parallel_blocks(surfels.count, 256, [&](int first, int last) {
        for (int i = first; i < last; ++i) {
            if (int_at(surfels, SURFEL_PLANE, i) < 0) continue;
            const Vec3 albedo = vector_at(surfels, SURFEL_ALBEDO_R, i);
            if (!(albedo.x > 0.0F || albedo.y > 0.0F || albedo.z > 0.0F)) continue;
            const NearPencils near = near_pencils(pencils, grid, vector_at(surfels, SURFEL_X, i), vector_at(surfels, SURFEL_NX, i));
            float4 sum(0.0F);
            for (int k = 0; k < 4 && near.index[k] >= 0; ++k) sum += near.weight[k] * irradiance[near.index[k]];
            outgoing.channel(0)[i] += sum.x * albedo.x * inverse_pi;
            outgoing.channel(1)[i] += sum.y * albedo.y * inverse_pi;
            outgoing.channel(2)[i] += sum.z * albedo.z * inverse_pi;
        }
    });
}

}  // namespace pencil::native
