// Sums of multiples of irradiance over all pencils of a set, channel by channel: how Krylov methods put solutions together.

/// launch : 1-D, one work-item per pencil
/// in     : vectors[vector_count][pencil_count]: irradiance [W m^-2], rgb; factors[vector_count]: of each, per channel
/// in/out : target[pencil_count]: sum_k factors[k] vectors[k] is added, in rising k
kernel void combine_irradiance(global const float4 *vectors, global const float4 *factors, int vector_count, int pencil_count,
                               global float4 *target) {
    int pencil = get_global_id(0);
    if (pencil >= pencil_count) return;
    float4 sum = target[pencil];
    for (int k = 0; k < vector_count; ++k) sum += factors[k] * vectors[(size_t)k * pencil_count + pencil];
    target[pencil] = sum;
}
