// All cores, over blocks of work.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace pencil::native {

/// work(first, last) for ranges of at most `block` that cover [0, count), in parallel.
template <typename Work>
void parallel_blocks(int count, int block, const Work& work) {
    const int blocks = (count + block - 1) / block;
    tbb::parallel_for(tbb::blocked_range<int>(0, blocks), [&](const tbb::blocked_range<int>& range) {
        for (int b = range.begin(); b != range.end(); ++b) work(b * block, std::min((b + 1) * block, count));
    });
}

}  // namespace pencil::native
