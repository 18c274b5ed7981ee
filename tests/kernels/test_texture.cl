// Values of textures (texture.cl) by themselves.

#include "lib/packet.cl"
#include "lib/texture.cl"

/// launch : 1-D, one work-item per point          in : points[count]: xy: uv          out : values[count]: of texture `texture`
kernel void texture_values(global const TextureRow *textures, int texture, global const half *texels, global const float4 *points,
                           int count, global float4 *values) {
    int i = get_global_id(0);
    if (i >= count) return;
    TexturePoint at = {points[i].xy, (float3)(points[i].xy, 1.0f - points[i].x - points[i].y), 0};
    values[i] = texture_or_one(texture, textures, texels, &at);
}

/// launch : the same                              out : slopes[count]: by u and v
kernel void texture_slopes(global const TextureRow *textures, int texture, global const half *texels, global const float4 *points,
                           int count, global float4 *slopes) {
    int i = get_global_id(0);
    if (i >= count) return;
    TexturePoint at = {points[i].xy, (float3)(0.0f), 0};
    slopes[i] = (float4)(texture_slope(textures + texture, texels, &at), 0.0f, 0.0f);
}
