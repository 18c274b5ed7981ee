#include "bench/native/parallel.h"
#include "bench/native/surface.h"
#include "bench/native/surface_pencil.h"

namespace pencil::native {

void transport_irradiance(const SurfelsView& surfels, const glm::ivec4* links, const float4* weights, int count, int n,
                          const float4* source, float4* target, float4* total) {
    const int texels = n * n;
    parallel_blocks(count, 16, [&](int first, int last) {
        for (int p = first; p < last; ++p) {
            float4v sum{};
            for (int i = p * texels; i < (p + 1) * texels; ++i) {
                const glm::ivec4& link = links[i];
                if (link.x < 0) continue;
                float4v e = weights[i].x * load4(source[link.x]);
                for (int k = 1; k < 4; ++k)
                    if (link[k] >= 0) e += weights[i][k] * load4(source[link[k]]);
                const Vec3 albedo = vector_at(surfels, SURFEL_ALBEDO_R, i);
                sum += e * float4v{albedo.x, albedo.y, albedo.z, 0.0F};
            }
            sum = sum / static_cast<float>(texels) + load4(target[p]);
            store(sum, target + p);
            store(sum + load4(total[p]), total + p);
        }
    });
}

}  // namespace pencil::native
