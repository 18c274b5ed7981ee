// The PCG hash of 32 bits (kernels/lib/hash.cl).
#pragma once

#include "bench/native/simd.h"

namespace pencil::native {

inline unsigned hash_uint(unsigned v) {
    const unsigned state = v * 747796405U + 2891336453U, word = ((state >> ((state >> 28U) + 4U)) ^ state) * 277803737U;
    return (word >> 22U) ^ word;
}

/// Random bits to [0, 1): the upper 24.
inline float unit(unsigned bits) { return static_cast<float>(bits >> 8U) * 0x1.0p-24F; }

}  // namespace pencil::native
