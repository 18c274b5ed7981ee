#include "bench/native/parallel.h"
#include "bench/native/surface.h"
#include "bench/native/surface_pencil.h"

namespace pencil::native {
namespace {

float approach(const SceneView& scene, const SurfelsView& surfels, int first, int texels, const float* near_area, const Vec3& at) {
    float shares = 0.0F, inverse = 0.0F, most = 0.0F;
    for (int i = first; i < first + texels; ++i) {
        const int m = int_at(surfels, SURFEL_MATERIAL, i);
        if (m < 0 || m == PENCIL_NO_MATERIAL) continue;
        const float4& emission = scene.materials[m].emission;
        if (!(emission.x > 0.0F || emission.y > 0.0F || emission.z > 0.0F)) continue;
        const Vec3 step = vector_at(surfels, SURFEL_X, i) - at;
        const float square = dot(step, step), share = near_area[m] < infinite ? near_area[m] / (square + near_area[m]) : 1.0F;
        shares += share;
        inverse += share / std::max(std::sqrt(square), position_error(at));
        most = std::max(most, share);
    }
    return inverse > 0.0F ? shares / (inverse * most) : infinite;
}

}  // namespace

void approach_emitters(const SceneView& scene, const SurfelsView& surfels, int count, int n, const float* near_area,
                       SurfacePencil* pencils) {
    parallel_blocks(
        count, 16,
        [&](int first, int last) {
            for (int p = first; p < last; ++p)
                pencils[p].emitters = approach(scene, surfels, p * n * n, n * n, near_area, xyz(pencils[p].position));
        });
}

}  // namespace pencil::native
