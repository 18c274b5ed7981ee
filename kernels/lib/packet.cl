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
#define PACKET_LANES (vint)(0)
#define PACKET_LANE_BIT 1
#define PACKET_BITS(mask) ((mask)&1)
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
#define PACKET_ANY(mask) any(mask)
#define PACKET_TO_INT(v) PACKET_JOIN(convert_int, PENCIL_WIDTH)(v)
#define PACKET_TO_FLOAT(v) PACKET_JOIN(convert_float, PENCIL_WIDTH)(v)
#define PACKET_AS_UINT(v) PACKET_JOIN(as_uint, PENCIL_WIDTH)(v)
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
// The lanes of a mask as bits of an int, lane 0 lowest.
inline int packet_bits(vint mask) {
#if PENCIL_WIDTH == 16
    int8 b8 = (mask & PACKET_LANE_BIT).lo | (mask & PACKET_LANE_BIT).hi;
    int4 b4 = b8.lo | b8.hi;
#elif PENCIL_WIDTH == 8
    int4 b4 = (mask & PACKET_LANE_BIT).lo | (mask & PACKET_LANE_BIT).hi;
#else
    int4 b4 = mask & PACKET_LANE_BIT;
#endif
    int2 b2 = b4.lo | b4.hi;
    return b2.x | b2.y;
}
#define PACKET_BITS(mask) packet_bits(mask)
#endif

/// The mask of lanes whose bits are set, and the lowest lane of bits that are not 0.
#define PACKET_FROM_BITS(bits) PACKET_MASK(((vint)(bits)&PACKET_LANE_BIT) != 0)
#define LOWEST_LANE(bits) (31 - clz((bits) & -(bits)))

/// One lane of a packet in private memory.
#define LANE_FLOAT(v, l) (((const float *)&(v))[l])
#define LANE_INT(v, l) (((const int *)&(v))[l])

/// Random bits to [0, 1): the upper 24.
#define PACKET_UNIT(bits) (PACKET_TO_FLOAT((bits) >> 8u) * 0x1.0p-24f)
