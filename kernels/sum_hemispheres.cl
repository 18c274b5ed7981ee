// Irradiance of surface pencils whose texels are lit.

/// launch : 1-D, one work-item per pencil of first_pencil ..
/// in     : radiance[3][capacity] that the texels send, from first_surfel on, n x n entries per pencil (trace_hemispheres)
/// out    : irradiance[first_pencil ..] = pi / n^2 * sum of radiance [W m^-2]
kernel void sum_hemispheres(global const float *radiance, int capacity, int first_surfel, int first_pencil, int pencil_count, int n,
                            global float4 *irradiance) {
    int item = get_global_id(0);
    if (item >= pencil_count) return;
    float3 sum = (float3)(0.0f);
    for (int i = 0; i < n * n; ++i) {
        size_t at = (size_t)first_surfel + (size_t)item * n * n + i;
        sum += (float3)(radiance[at], radiance[(size_t)capacity + at], radiance[2 * (size_t)capacity + at]);
    }
    irradiance[first_pencil + item] = (float4)(sum * (M_PI_F / (n * n)), 0.0f);
}
