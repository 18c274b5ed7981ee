// Adds light of one pencil set to another with the same maps.

/// launch : 1-D, one work-item per texel of the atlas, gutters included
/// in     : term; factor: rgb
/// out    : radiance[count], rgb: term times factor is added; w is kept
kernel void add_radiance(global const float4 *term, float4 factor, int count, global float4 *radiance) {
    int i = get_global_id(0);
    if (i < count) radiance[i].xyz += factor.xyz * term[i].xyz;
}
