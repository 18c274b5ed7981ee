// The environment (sky.cl) by itself.

#include "lib/sky.cl"

/// launch : 1-D, one work-item per direction
/// in     : directions[count]: xyz, w: density of sky_radiance          out : values[2 count]: sky_seen; sky_radiance
kernel void sky_values(SKY_PARAMETERS, global const float4 *directions, int count, global float4 *values) {
    int i = get_global_id(0);
    if (i >= count) return;
    float3 d = directions[i].xyz;
    values[2 * i] = (float4)(sky_seen(sky, sky_texels, d), 0.0f);
    values[2 * i + 1] = (float4)(sky_radiance(sky, sky_texels, d, directions[i].w), 0.0f);
}
