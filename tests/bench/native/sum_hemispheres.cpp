#include "bench/native/parallel.h"
#include "bench/native/simd.h"
#include "bench/native/surface.h"

namespace pencil::native {

void sum_hemispheres(RgbView radiance, int count, int n, float4* irradiance) {
    const int texels = n * n;  // a multiple of 16
    const float scale = 3.14159265F / static_cast<float>(texels);
    parallel_blocks(count, 64, [&](int first, int last) {
        for (int p = first; p < last; ++p) {
            float rgb[3];
            for (int c = 0; c < 3; ++c) {
                const float* from = radiance.channel(c) + static_cast<std::ptrdiff_t>(p) * texels;
                vfloat sum{};
                for (int i = 0; i < texels; i += lane_count) sum += load<vfloat>(from + i);
                rgb[c] = 0.0F;
                for (int l = 0; l < lane_count; ++l) rgb[c] += sum[l];
            }
            irradiance[p] = {rgb[0] * scale, rgb[1] * scale, rgb[2] * scale, 0.0F};
        }
    });
}

}  // namespace pencil::native
