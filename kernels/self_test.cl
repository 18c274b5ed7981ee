// Known answers: what the other kernels take for granted about a device and its compiler, each next to the host's own answer in
// host/cl/self_test.cpp. Inputs come from memory, so that the compiler cannot work the answers out itself.

#include "lib/packet.cl"
#include "self_test_layout.h"

#define SELF_TEST_SIZE(T) out[i++] = (uint)sizeof(T);
#define SELF_TEST_FIELD(T, member)                                                 \
    {                                                                              \
        T value;                                                                   \
        out[i++] = (uint)((private char *)&value.member - (private char *)&value); \
    }

/// Layout of the shared structs, in the order of PENCIL_LAYOUT.
/// launch : one work-item          out : one uint per entry
kernel void self_test_layout(global uint *out) {
    int i = 0;
    if (get_global_id(0) != 0) return;
    PENCIL_LAYOUT(SELF_TEST_SIZE, SELF_TEST_FIELD)
}

/// NaN, infinity, signed zero and rounding.
/// launch : one work-item          in : 0, 1, 3, 0.5, -2.5          out : 20 floats, see check_floats
kernel void self_test_floats(global const float *in, global float *out) {
    if (get_global_id(0) != 0) return;
    float zero = in[0], one = in[1], three = in[2], half_ = in[3], negative = in[4];
    float nan_ = zero / zero, infinity = one / zero;
    out[0] = (float)isnan(nan_);
    out[1] = (float)isfinite(nan_);
    out[2] = (float)isinf(infinity);
    out[3] = (float)isfinite(infinity);
    out[4] = fmax(nan_, half_);
    out[5] = fmin(half_, nan_);
    out[6] = (nan_ == nan_) ? 1.0f : 0.0f;
    out[7] = (nan_ < one || nan_ >= one) ? 1.0f : 0.0f;
    out[8] = one / infinity;
    out[9] = (float)isinf(one / -zero) * copysign(one, one / -zero);
    out[10] = copysign(one, -zero);
    out[11] = (float)((as_uint(nan_) & 0x7f800000u) == 0x7f800000u);
    out[12] = floor(negative);
    out[13] = rint(negative);
    out[14] = (float)convert_int(negative);
    out[15] = one / three;
    out[16] = sqrt(three);
    out[17] = rsqrt(three);
    out[18] = exp(negative);
    out[19] = pow(three, half_);
}

/// a * b + c as the compiler likes it, then as one rounding, then as two.
/// launch : one work-item          in : a, b, c          out : 3 floats
kernel void self_test_contraction(global const float *in, global float *out) {
    if (get_global_id(0) != 0) return;
    out[0] = in[0] * in[1] + in[2];
    out[1] = fma(in[0], in[1], in[2]);
    {
#pragma OPENCL FP_CONTRACT OFF
        out[2] = in[0] * in[1] + in[2];
    }
}

/// launch : one work-item          in : 0x9e3779b9, 7, -13 as uint          out : 10 uints, see check_integers
kernel void self_test_integers(global const uint *in, global uint *out) {
    if (get_global_id(0) != 0) return;
    uint a = in[0], b = in[1];
    int c = as_int(in[2]);
    ulong wide = (ulong)a * a;
    out[0] = a * a;
    out[1] = mul_hi(a, a);
    out[2] = (uint)(wide >> 32);
    out[3] = rotate(a, b);
    out[4] = popcount(a);
    out[5] = clz(b);
    out[6] = as_uint(c >> 1);
    out[7] = as_uint(c % (int)b);
    out[8] = as_uint(c / (int)b);
    out[9] = (uint)((wide * 0x5851f42d4c957f2dul) >> 40);
}

/// Load, compare, select, convert, pack and store whole packets.
/// launch : 1-D, one work-item per packet          in : `count` floats, a multiple of PENCIL_WIDTH
/// out    : values: the square where the input is above zero, else -1; lanes: the lane; any: 1 where the packet has a value above zero
///          packed: the lanes of the packet whose input is above zero one after the other, then -1
kernel void self_test_packets(global const float *in, int count, global float *values, global int *lanes, global int *any_positive,
                              global int *packed) {
    int packet = get_global_id(0);
    if (packet >= count / PENCIL_WIDTH) return;
    int first = packet * PENCIL_WIDTH;
    vfloat v = PACKET_LOAD(in + first);
    vint positive = PACKET_MASK(v > 0.0f);
    PACKET_STORE(select((vfloat)(-1.0f), v * v, positive), values + first);
    PACKET_STORE(PACKET_TO_INT(PACKET_TO_FLOAT(PACKET_LANES)), lanes + first);
    any_positive[packet] = PACKET_ANY(positive) ? 1 : 0;
    int list[PENCIL_WIDTH], bits = PACKET_BITS(positive);
    packet_store_packed(PACKET_LANES, bits, list);
    for (int l = 0; l < PENCIL_WIDTH; ++l) packed[first + l] = l < popcount(bits) ? list[l] : -1;
}

/// Sum in a fixed order: one value per work-item, then pairs at half the distance until one is left.
/// launch : 1-D, groups of SELF_TEST_GROUP items          in : a multiple of SELF_TEST_GROUP floats          out : one sum per group
kernel __attribute__((reqd_work_group_size(SELF_TEST_GROUP, 1, 1))) void self_test_reduction(global const float *in, global float *out) {
    local float partial[SELF_TEST_GROUP];
    int item = get_local_id(0);
    partial[item] = in[get_global_id(0)];
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int distance = SELF_TEST_GROUP / 2; distance > 0; distance /= 2) {
        if (item < distance) partial[item] += partial[item + distance];
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    if (item == 0) out[get_group_id(0)] = partial[0];
}
