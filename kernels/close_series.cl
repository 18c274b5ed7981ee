// The end of the world's bounces: what all further ones would add is a geometric series of the last.

/// launch : 1-D, one work-item per pencil
/// in     : last[pencil_count]: irradiance of the last bounce; tail: all further bounces relative to it (BounceSeries::tail_factor); w 0
/// in/out : total[pencil_count]: tail * last is added [W m^-2]
kernel void close_series(global const float4 *last, float4 tail, int pencil_count, global float4 *total) {
    // Rounded twice on every device.
#pragma OPENCL FP_CONTRACT OFF
    int pencil = get_global_id(0);
    if (pencil >= pencil_count) return;
    float4 rest = tail * last[pencil];
    total[pencil] += rest;
}
