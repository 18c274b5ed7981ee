// Inner products of irradiance over all pencils of a set, channel by channel: what Krylov methods measure with.

/// launch : 1-D, one work-item per part of a product
/// in     : vectors[vector_count][pencil_count], other[pencil_count]: irradiance [W m^-2], rgb; w 0
/// out    : sums[vector_count][part_count]: the sum of `part_count` parts is dot(vector, other) in each channel. A part takes every
///          part_count-th pencil in rising order: the same bits each time, and no atomics.
kernel void dot_irradiance(global const float4 *vectors, int vector_count, global const float4 *other, int pencil_count, int part_count,
                           global float4 *sums) {
    int item = get_global_id(0);
    int vector = item / part_count, part = item % part_count;
    if (vector >= vector_count) return;
    global const float4 *own = vectors + (size_t)vector * pencil_count;
    float4 sum = (float4)(0.0f);
    for (int i = part; i < pencil_count; i += part_count) sum += own[i] * other[i];
    sums[item] = sum;
}
