#include "bench/native/parallel.h"
#include "bench/native/surface.h"

namespace pencil::native {

void close_series(const float4* last, const float4& tail, int count, float4* total) {
    parallel_blocks(count, 4096, [&](int first, int end) {
        for (int p = first; p < end; ++p) total[p] += tail * last[p];
    });
}

}  // namespace pencil::native
