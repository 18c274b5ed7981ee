#include "bench/native/parallel.h"
#include "bench/native/surface.h"
#include "bench/native/surface_pencil.h"

namespace pencil::native {

void place_surface_pencils(const SurfelsView& surfels, const int* chosen, const uint* keys, const float4* views, int count, int spacing,
                           SurfacePencil* pencils) {
    parallel_blocks(
        count, 1024,
        [&](int first, int last) {
            for (int k = first; k < last; ++k) {
                const int i = chosen[k];
                const Vec3 x = vector_at(surfels, SURFEL_X, i), n = vector_at(surfels, SURFEL_NX, i), g = vector_at(surfels, SURFEL_GX, i),
                           towards = xyz(views[k]) - x;
                const float distance = std::sqrt(dot(towards, towards)), nearer = 30.0F * position_error(x),
                            share = std::min(nearer / std::max(distance, nearer), 1e-2F);
                SurfacePencil p{};
                p.position = {x.x + towards.x * share, x.y + towards.y * share, x.z + towards.z * share, 0.0F};
                p.normal = {n.x, n.y, n.z, views[k].w};
                p.facing = {g.x, g.y, g.z, 0.0F};
                p.plane = int_at(surfels, SURFEL_PLANE, i);
                p.key = keys[k];
                p.spacing = spacing;
                pencils[k] = p;
            }
        });
}

}  // namespace pencil::native
