// Packets of PENCIL_WIDTH surfels: the hot kernels are written once and compiled for the width of the device (1 on GPUs, the native
// float width on CPUs, where the compiler does not vectorise work-items across inner loops). Masks are -1 for true, 0 for false.

#ifndef PENCIL_WIDTH
#error PENCIL_WIDTH is not defined: surfels per work-item, 1, 4, 8 or 16
#endif

#if PENCIL_WIDTH == 1
typedef float vfloat;
typedef int vint;
typedef uint vuint;
#define PACKET_LOAD(p) (*(p))
#define PACKET_STORE(v, p) (*(p) = (v))
#define PACKET_MASK(condition) (-(condition))
#define PACKET_ANY(mask) (mask)
#define PACKET_TO_INT(v) convert_int(v)
#define PACKET_TO_FLOAT(v) convert_float(v)
#define PACKET_AS_UINT(v) as_uint(v)
#define PACKET_AS_INT(v) as_int(v)
#define PACKET_LOAD_USHORT(p) convert_int(*(p))
#define PACKET_LANES (vint)(0)
#define PACKET_LANE_BIT 1
#define PACKET_BITS(mask) ((mask)&1)
#define LOWEST_LANE(bits) 0
#define PACKET_LOAD_PAIRS(p, a, b) (a) = (p)[0], (b) = (p)[1]
#else
#define PACKET_JOIN2(a, b) a##b
#define PACKET_JOIN(a, b) PACKET_JOIN2(a, b)
typedef PACKET_JOIN(float, PENCIL_WIDTH) vfloat;
typedef PACKET_JOIN(int, PENCIL_WIDTH) vint;
typedef PACKET_JOIN(uint, PENCIL_WIDTH) vuint;
#define PACKET_LOAD(p) PACKET_JOIN(vload, PENCIL_WIDTH)(0, (p))
#define PACKET_STORE(v, p) PACKET_JOIN(vstore, PENCIL_WIDTH)((v), 0, (p))
#define PACKET_MASK(condition) (condition)
#define PACKET_TO_INT(v) PACKET_JOIN(convert_int, PENCIL_WIDTH)(v)
#define PACKET_TO_FLOAT(v) PACKET_JOIN(convert_float, PENCIL_WIDTH)(v)
#define PACKET_AS_UINT(v) PACKET_JOIN(as_uint, PENCIL_WIDTH)(v)
#define PACKET_AS_INT(v) PACKET_JOIN(as_int, PENCIL_WIDTH)(v)
#define PACKET_LOAD_USHORT(p) PACKET_TO_INT(PACKET_LOAD(p))
// Splits PENCIL_WIDTH pairs of ints into their first and second members.
#if PENCIL_WIDTH == 16
#define PACKET_LOAD_PAIRS(p, a, b) (a) = (vint)(vload16(0, p).even, vload16(1, p).even), (b) = (vint)(vload16(0, p).odd, vload16(1, p).odd)
#else
#define PACKET_LOAD_PAIRS(p, a, b) (a) = PACKET_JOIN(vload, PACKET_TWICE)(0, p).even, (b) = PACKET_JOIN(vload, PACKET_TWICE)(0, p).odd
#endif
#if PENCIL_WIDTH == 4
#define PACKET_TWICE 8
#define PACKET_LANES (vint)(0, 1, 2, 3)
#elif PENCIL_WIDTH == 8
#define PACKET_TWICE 16
#define PACKET_LANES (vint)(0, 1, 2, 3, 4, 5, 6, 7)
#elif PENCIL_WIDTH == 16
#define PACKET_LANES (vint)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15)
#endif
#define PACKET_LANE_BIT ((vint)(1) << PACKET_LANES)
#define LOWEST_LANE(bits) popcount(~(bits) & ((bits)-1))
#endif

/// The mask of lanes whose bits are set. LOWEST_LANE: of bits that are not 0.
#define PACKET_FROM_BITS(bits) PACKET_MASK(((vint)(bits)&PACKET_LANE_BIT) != 0)

/// The smaller of two numbers: one instruction, where fmin minds NaN.
#define PACKET_MIN(a, b) ((b) < (a) ? (b) : (a))

/// One lane of a packet in private memory.
#define LANE_FLOAT(v, l) (((const float *)&(v))[l])
#define LANE_INT(v, l) (((const int *)&(v))[l])

/// Random bits to [0, 1): the upper 24, all that a float holds.
#define UNIT_SHIFT 8u
#define UNIT_STEP 0x1.0p-24f
#define PACKET_UNIT(bits) (PACKET_TO_FLOAT((bits) >> UNIT_SHIFT) * UNIT_STEP)

// Steps that are one instruction of an x86 CPU, for which OpenCL C has no word. Clang defines these macros for such a CPU only; all other
// compilers see plain OpenCL C.
#ifdef __clang__
#if PENCIL_WIDTH == 16 && defined(__AVX512DQ__) && __has_builtin(__builtin_ia32_cvtd2mask512) && \
    __has_builtin(__builtin_ia32_rsqrt14ps512_mask) && __has_builtin(__builtin_ia32_compresssi512_mask)
#define PACKET_AVX512
#elif PENCIL_WIDTH >= 8 && defined(__AVX__) && __has_builtin(__builtin_ia32_movmskps256)
#define PACKET_AVX
#endif
#ifdef __x86_64__
/// Asks for the cache line at p, of whatever address space: they are one on a CPU.
#define PREFETCH(p) __builtin_prefetch((const void *)(uintptr_t)(p))
#endif
#endif
#ifndef PREFETCH
#define PREFETCH(p)
#endif

#if PENCIL_WIDTH > 1
/// The lanes of a mask as bits of an int, lane 0 lowest.
static inline int packet_bits(vint mask) {
#if defined(PACKET_AVX512)
    return (ushort)__builtin_ia32_cvtd2mask512(mask);
#elif defined(PACKET_AVX) && PENCIL_WIDTH == 16
    return __builtin_ia32_movmskps256(as_float8(mask.lo)) | __builtin_ia32_movmskps256(as_float8(mask.hi)) << 8;
#elif defined(PACKET_AVX)
    return __builtin_ia32_movmskps256(as_float8(mask));
#else
    int bits[PENCIL_WIDTH], all = 0;
    PACKET_STORE(mask & PACKET_LANE_BIT, bits);
    for (int l = 0; l < PENCIL_WIDTH; ++l) all |= bits[l];
    return all;
#endif
}
#define PACKET_BITS(mask) packet_bits(mask)
#define PACKET_ANY(mask) (packet_bits(mask) != 0)
#endif

/// 1 / sqrt(v) within 4 units in the last place for v > 0 (test_packet.cpp); anything for v = 0.
static inline vfloat packet_rsqrt(vfloat v) {
#ifdef PACKET_AVX512
    // An estimate of 14 bits and one Newton step: a fraction of the time of a root and a division.
    vfloat y = __builtin_ia32_rsqrt14ps512_mask(v, (vfloat)(0.0f), (ushort)-1);
    return y * fma(-0.5f * v * y, y, (vfloat)(1.5f));
#else
    return rsqrt(v);
#endif
}

/// Writes the lanes of v whose bits are set one after the other to `to`, which has room for a whole packet.
static inline void packet_store_packed(vint v, int bits, int *to) {
#ifdef PACKET_AVX512
    typedef int unaligned __attribute__((ext_vector_type(16), aligned(4)));
    *(unaligned *)to = __builtin_ia32_compresssi512_mask(v, (vint)(0), (ushort)bits);
#else
    for (; bits; bits &= bits - 1) *to++ = LANE_INT(v, LOWEST_LANE(bits));
#endif
}

/// Sum of the lanes, by halves: in the same order as that of two packets of half the width, lane by lane, and then of their lanes.
static inline float packet_sum(vfloat v) {
#if PENCIL_WIDTH == 16
    float8 a = v.lo + v.hi;
    float4 b = a.lo + a.hi;
    return (b.x + b.z) + (b.y + b.w);
#elif PENCIL_WIDTH == 8
    float4 b = v.lo + v.hi;
    return (b.x + b.z) + (b.y + b.w);
#elif PENCIL_WIDTH == 4
    return (v.x + v.z) + (v.y + v.w);
#else
    return v;
#endif
}
