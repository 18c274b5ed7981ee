// The functions of a model of scattering by themselves, for bsdf_laws.h. TEST_MODEL: name of the model; bsdf: the one that the row names.

#include "lib/surfaces.cl"

#define TEST_JOIN2(a, b) a##b
#define TEST_JOIN(a, b) TEST_JOIN2(a, b)
#define MODEL(function) TEST_JOIN(TEST_MODEL, function)

/// The row as surfaces without textures know it.
static inline Bsdf bsdf_of_row(global const Material *row, global const half *tables, int front) {
    Surfaces scene = {0, 0, row, 0, 0, 0, tables};
    TexturePoint at = {(float2)(0.0f), (float3)(0.0f), 0};
    return bsdf_at(&scene, 0, front, &at);
}

/// launch : 1-D, one work-item per pair of directions
/// out    : values[2 count]: rgb: lobes times |cos_i| [1/sr], w: pdf [1/sr]; x: base_factor
kernel void bsdf_pairs(global const Material *row, global const half *tables, int front, global const float4 *omega_o,
                       global const float4 *omega_i, int count, global float4 *values) {
    int i = get_global_id(0);
    if (i >= count) return;
    Bsdf b = bsdf_of_row(row, tables, front);
    float3 o = omega_o[i].xyz, in = omega_i[i].xyz;
    values[2 * i] = (float4)(MODEL(_evaluate)(&b, o, in), MODEL(_pdf)(&b, o, in));
    values[2 * i + 1] = (float4)(in.z > 0.0f ? MODEL(_base_factor)(&b, o, in) : 0.0f);
}

/// launch : 1-D, one work-item per sample          in : u[count] in [0, 1)^3
/// out    : samples[2 count]: xyz: omega_i, w: its density; rgb: weight
kernel void bsdf_samples(global const Material *row, global const half *tables, int front, float4 omega_o, global const float4 *u,
                         int count, global float4 *samples) {
    int i = get_global_id(0);
    if (i >= count) return;
    Bsdf b = bsdf_of_row(row, tables, front);
    BsdfSample s = MODEL(_sample)(&b, omega_o.xyz, u[i].xyz);
    samples[2 * i] = (float4)(s.omega_i, s.pdf);
    samples[2 * i + 1] = (float4)(s.weight, 0.0f);
}

/// launch : 1-D, one work-item per direction          out : values[2 count]: rgb: base; rgb: share
kernel void bsdf_even(global const Material *row, global const half *tables, int front, global const float4 *omega_o, int count,
                      global float4 *values) {
    int i = get_global_id(0);
    if (i >= count) return;
    Bsdf b = bsdf_of_row(row, tables, front);
    values[2 * i] = (float4)(MODEL(_base)(&b, omega_o[i].xyz), 0.0f);
    values[2 * i + 1] = (float4)(MODEL(_share)(&b, omega_o[i].xyz), 0.0f);
}
