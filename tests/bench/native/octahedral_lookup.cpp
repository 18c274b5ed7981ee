#include "bench/native/native.h"
#include "bench/native/octahedral.h"
#include "bench/native/parallel.h"

namespace pencil::native {

void octahedral_lookup(const float* x, const float* y, const float* z, int count, const MapsView& maps, const float4* radiance,
                       float4* sum) {
    constexpr int block = 128;
    const int stride = PENCIL_TILE_STRIDE(maps.n);
    parallel_blocks(count, block, [&](int first, int last) {
        float4v sums[block] = {};
        alignas(64) int index[lane_count];
        alignas(64) float fx[lane_count], fy[lane_count];
        for (int t = 0; t < maps.count; ++t) {
            const float4& cop = maps.cops[t];
            const float4* texels = radiance + static_cast<std::size_t>(t) * maps.tile_texels();
            for (int i = first; i < last; i += lane_count) {
                const Footprints f =
                    footprints(load<vfloat>(x + i) - cop.x, load<vfloat>(y + i) - cop.y, load<vfloat>(z + i) - cop.z, maps.n);
                store(f.index, index);
                store(f.fx, fx);
                store(f.fy, fy);
#pragma GCC unroll 16
                for (int l = 0; l < lane_count; ++l) sums[i - first + l] += fetch(texels + index[l], stride, fx[l], fy[l]);
            }
        }
        for (int i = first; i < last; ++i) store(sums[i - first], sum + i);
    });
}

}  // namespace pencil::native
