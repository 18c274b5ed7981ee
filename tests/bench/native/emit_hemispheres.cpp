#include "bench/native/parallel.h"
#include "bench/native/surface.h"
#include "bench/native/surface_pencil.h"

namespace pencil::native {

void emit_hemispheres(const SceneView& scene, const SurfelsView& surfels, const SurfacePencil* pencils, int n, const float* near_area,
                      RgbView radiance) {
    parallel_blocks(
        surfels.count, 4096,
        [&](int first, int last) {
            for (int i = first; i < last; ++i) {
                const int m = int_at(surfels, SURFEL_MATERIAL, i);
                if (m < 0 || m == PENCIL_NO_MATERIAL) continue;
                const float4& emission = scene.materials[m].emission;
                if (!(emission.x > 0.0F || emission.y > 0.0F || emission.z > 0.0F)) continue;
                const Vec3 step = vector_at(surfels, SURFEL_X, i) - xyz(pencils[i / (n * n)].position);
                const float share = near_area[m] < infinite ? near_area[m] / (dot(step, step) + near_area[m]) : 1.0F;
                for (int c = 0; c < 3; ++c) radiance.channel(c)[i] += share * emission[c];
            }
        });
}

}  // namespace pencil::native
