#include "bench/native/near_pencils.h"
#include "bench/native/parallel.h"
#include "bench/native/surface.h"

namespace pencil::native {

void project_contacts(const SurfelsView& surfels, const int* chosen, const float* counts, int count, const float4* irradiance,
                      RgbView outgoing) {
    constexpr float inverse_pi = 0.318309886F;
    parallel_blocks(count, 256, [&](int first, int last) {
        for (int k = first; k < last; ++k) {
            const Vec3 albedo = vector_at(surfels, SURFEL_ALBEDO_R, chosen[k]);
            const float scale = counts[k] * inverse_pi;
            outgoing.channel(0)[chosen[k]] += scale * irradiance[k].x * albedo.x;
            outgoing.channel(1)[chosen[k]] += scale * irradiance[k].y * albedo.y;
            outgoing.channel(2)[chosen[k]] += scale * irradiance[k].z * albedo.z;
        }
    });
}

}  // namespace pencil::native
