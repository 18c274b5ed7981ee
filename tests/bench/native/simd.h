// Vectors of the native loops: GCC's vector extensions, as wide as the CPU's registers, and vectors of four for points.
#pragma once

#include <cstring>
#include <glm/vec4.hpp>

#ifdef __AVX512F__
#include <immintrin.h>
#endif

namespace pencil::native {

#ifdef __AVX512F__
constexpr int lane_count = 16;
#else
constexpr int lane_count = 8;
#endif
constexpr unsigned all_lanes_set = (1U << lane_count) - 1U;

typedef float vfloat __attribute__((vector_size(4 * lane_count)));
typedef int vint __attribute__((vector_size(4 * lane_count)));
typedef float float8v __attribute__((vector_size(32)));
typedef float float4v __attribute__((vector_size(16)));
typedef int int4v __attribute__((vector_size(16)));

template <typename Vector, typename Element>
inline Vector load(const Element* p) {
    Vector v;
    std::memcpy(&v, p, sizeof v);
    return v;
}
template <typename Vector, typename Element>
inline void store(const Vector& v, Element* p) {
    std::memcpy(p, &v, sizeof v);
}

inline vfloat broadcast(float x) { return vfloat{} + x; }
inline vint broadcast(int x) { return vint{} + x; }
inline vint bits(vfloat v) { return reinterpret_cast<vint>(v); }
inline vfloat floats(vint v) { return reinterpret_cast<vfloat>(v); }

inline vfloat absolute(vfloat v) { return floats(bits(v) & 0x7fffffff); }
inline vfloat copy_sign(vfloat magnitude, vfloat sign) { return floats((bits(magnitude) & 0x7fffffff) | (bits(sign) & ~0x7fffffff)); }

inline vint lane_numbers() {
    vint lanes;
    for (int l = 0; l < lane_count; ++l) lanes[l] = l;
    return lanes;
}

#ifdef __AVX512F__
inline vfloat maximum(vfloat a, vfloat b) { return reinterpret_cast<vfloat>(_mm512_max_ps(a, b)); }
inline vfloat minimum(vfloat a, vfloat b) { return reinterpret_cast<vfloat>(_mm512_min_ps(a, b)); }
/// One bit per lane of a mask of 0 and -1.
inline unsigned lane_mask(vint mask) { return _mm512_cmplt_epi32_mask(reinterpret_cast<__m512i>(mask), _mm512_setzero_si512()); }
/// Hardware estimate of 14 bits and one Newton step: good to a few units in the last place.
inline vfloat reciprocal_sqrt(vfloat v) {
    const vfloat y = _mm512_rsqrt14_ps(v);
    return y * (1.5F - 0.5F * v * y * y);
}
/// Members first (even) and second (odd) of pairs p[index[l]].
inline void gather_pairs(const void* pairs, const int* index, vint& first, vint& second) {
    const auto* p = static_cast<const long long*>(pairs);
    const __m512i low =
        _mm512_set_epi64(p[index[7]], p[index[6]], p[index[5]], p[index[4]], p[index[3]], p[index[2]], p[index[1]], p[index[0]]);
    const __m512i high =
        _mm512_set_epi64(p[index[15]], p[index[14]], p[index[13]], p[index[12]], p[index[11]], p[index[10]], p[index[9]], p[index[8]]);
    const __m512i even = _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
    first = reinterpret_cast<vint>(_mm512_permutex2var_epi32(low, even, high));
    second = reinterpret_cast<vint>(_mm512_permutex2var_epi32(low, _mm512_add_epi32(even, _mm512_set1_epi32(1)), high));
}
/// Writes the lanes of `mask` one after the other to `to`, which has room for a whole vector.
inline void store_packed(vint v, unsigned mask, int* to) {
    store(_mm512_maskz_compress_epi32(static_cast<__mmask16>(mask), reinterpret_cast<__m512i>(v)), to);
}
#else
inline vfloat maximum(vfloat a, vfloat b) { return a > b ? a : b; }
inline vfloat minimum(vfloat a, vfloat b) { return a < b ? a : b; }
inline unsigned lane_mask(vint mask) {
    unsigned out = 0;
    for (int l = 0; l < lane_count; ++l) out |= mask[l] != 0 ? 1U << l : 0U;
    return out;
}
inline vfloat reciprocal_sqrt(vfloat v) {
    vfloat root;
    for (int l = 0; l < lane_count; ++l) root[l] = __builtin_sqrtf(v[l]);
    return 1.0F / root;
}
inline void gather_pairs(const void* pairs, const int* index, vint& first, vint& second) {
    const auto* p = static_cast<const int*>(pairs);
    for (int l = 0; l < lane_count; ++l) {
        first[l] = p[2 * index[l]];
        second[l] = p[2 * index[l] + 1];
    }
}
inline void store_packed(vint v, unsigned mask, int* to) {
    for (; mask != 0; mask &= mask - 1) *to++ = v[__builtin_ctz(mask)];
}
#endif
inline void store_packed(vfloat v, unsigned mask, float* to) { store_packed(bits(v), mask, reinterpret_cast<int*>(to)); }

// Points and planes as vectors of four; w of points is 0.

inline float4v load_point(const glm::vec4& v) { return float4v{v.x, v.y, v.z, 0.0F}; }
inline float4v load4(const glm::vec4& v) { return load<float4v>(&v); }
inline float dot3(float4v a, float4v b) {
    const float4v p = a * b;
    return p[0] + p[1] + p[2];
}

}  // namespace pencil::native
