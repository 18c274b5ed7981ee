#include "bench/native/native.h"
#include "bench/native/octahedral.h"
#include "bench/native/parallel.h"

namespace pencil::native {

void sum_radiance(const float4* radiance, int count, int n, float4* means) {
    parallel_blocks(
        count, 1,
        [&](int tile, int) {
            float4v sum{};
            for (int y = 0; y < n; ++y) {
                const float4* row =
                    radiance + static_cast<std::size_t>(tile) * static_cast<std::size_t>(PENCIL_TILE_TEXELS(n)) + tile_index({0, y}, n);
                float4v part[4] = {};  // independent chains
                for (int x = 0; x < n; ++x) part[x % 4] += load4(row[x]);
                sum += (part[0] + part[1]) + (part[2] + part[3]);
            }
            store(sum / static_cast<float>(n * n), means + tile);
        });
}

}  // namespace pencil::native
