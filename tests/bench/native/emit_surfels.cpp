#include <cstring>

#include "bench/native/native.h"
#include "bench/native/parallel.h"

namespace pencil::native {

void emit_surfels(const SceneView& scene, const SurfelsView& surfels, RgbView radiance) {
    parallel_blocks(
        surfels.count, 4096,
        [&](int first, int last) {
            for (int i = first; i < last; ++i) {
                int m = 0;
                std::memcpy(&m, surfels.field(SURFEL_MATERIAL) + i, sizeof m);
                if (m < 0 || m == PENCIL_NO_MATERIAL) continue;
                const float4& emission = scene.materials[m].emission;
                for (int c = 0; c < 3; ++c) radiance.channel(c)[i] += emission[c];
            }
        });
}

}  // namespace pencil::native
