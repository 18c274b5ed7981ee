// One tile at a time in the nearest cache: transposed and turned into a sharp tile, then smoothed by a separable (1 2 1).
#include <vector>

#include "bench/native/native.h"
#include "bench/native/octahedral.h"
#include "bench/native/parallel.h"

namespace pencil::native {
namespace {

/// Interior texels of `sharp` from the surfels of one tile, then its gutter.
void sharp_tile(const float* outgoing, std::size_t capacity, int n, const float4* radiance, std::vector<float4v>& sharp) {
    for (int i = 0; i < n * n; ++i) {
        const int target = tile_index(antipode(surfel_texel(i, n), n), n);
        sharp[static_cast<std::size_t>(target)] = float4v{outgoing[i], outgoing[capacity + static_cast<std::size_t>(i)],
                                                          outgoing[2 * capacity + static_cast<std::size_t>(i)], radiance[target].w};
    }
    const auto fill = [&](int x, int y) {
        sharp[static_cast<std::size_t>(tile_index({x, y}, n))] = sharp[static_cast<std::size_t>(tile_index(fold_texel({x, y}, n), n))];
    };
    for (int k = -1; k <= n; ++k) {
        fill(k, -1);
        fill(k, n);
        fill(-1, k);
        fill(n, k);
    }
}

void smooth_tile(const std::vector<float4v>& sharp, int n, float4* radiance) {
    const int stride = PENCIL_TILE_STRIDE(n);
    for (int y = 0; y < n; ++y) {
        const float4v* row = sharp.data() + (y + 1) * stride;
        const auto column = [&](int x) { return row[x - stride] + 2.0F * row[x] + row[x + stride]; };
        float4v left = column(0), middle = column(1);
        for (int x = 1; x <= n; ++x) {
            const float4v right = column(x + 1);
            float4v smooth = (left + 2.0F * middle + right) * 0.0625F;
            smooth[3] = row[x][3];
            store(smooth, radiance + (y + 1) * stride + x);
            left = middle;
            middle = right;
        }
    }
    const auto fill = [&](int x, int y) { radiance[tile_index({x, y}, n)] = radiance[tile_index(fold_texel({x, y}, n), n)]; };
    for (int k = -1; k <= n; ++k) {
        fill(k, -1);
        fill(k, n);
        fill(-1, k);
        fill(n, k);
    }
}

}  // namespace

void store_radiance(const float* outgoing, std::size_t capacity, int count, int n, float4* radiance) {
    const auto texels = static_cast<std::size_t>(PENCIL_TILE_TEXELS(n));
    parallel_blocks(count, 1, [&](int tile, int) {
        thread_local std::vector<float4v> sharp;
        sharp.resize(texels);
        float4* target = radiance + static_cast<std::size_t>(tile) * texels;
        sharp_tile(outgoing + static_cast<std::size_t>(tile) * static_cast<std::size_t>(n * n), capacity, n, target, sharp);
        smooth_tile(sharp, n, target);
    });
}

}  // namespace pencil::native
