// The functions of a model of reflection by themselves, for brdf_laws.h. TEST_MODEL: name of the model; brdf: the one that a material
// names.

#include "lib/brdf.cl"
#include "lib/packet.cl"
#include "shared/material.h"

#define TEST_JOIN2(a, b) a##b
#define TEST_JOIN(a, b) TEST_JOIN2(a, b)
#define MODEL(function) TEST_JOIN(TEST_MODEL, function)

/// launch : 1-D, one work-item per pair of directions          out : values[count]: rgb: f [1/sr], w: pdf [1/sr]
kernel void brdf_pairs(global const Material *material, global const float4 *omega_o, global const float4 *omega_i, int count,
                       global float4 *values) {
    int i = get_global_id(0);
    if (i >= count) return;
    values[i].xyz = MODEL(_evaluate)(material, omega_o[i].xyz, omega_i[i].xyz);
    values[i].w = MODEL(_pdf)(material, omega_o[i].xyz, omega_i[i].xyz);
}

/// launch : 1-D, one work-item per sample          in : u[count] in [0, 1)^2          out : omega_i[count]: xyz
kernel void brdf_samples(global const Material *material, float4 omega_o, global const float2 *u, int count, global float4 *omega_i) {
    int i = get_global_id(0);
    if (i < count) omega_i[i] = (float4)(MODEL(_sample)(material, omega_o.xyz, u[i]), 0.0f);
}

/// launch : 1-D, one work-item per direction          out : albedos[count]: rgb
kernel void brdf_albedos(global const Material *material, global const float4 *omega_o, int count, global float4 *albedos) {
    int i = get_global_id(0);
    if (i < count) albedos[i] = (float4)(MODEL(_albedo)(material, omega_o[i].xyz), 0.0f);
}

/// The forms of scattering K (brdf.cl), of PENCIL_WIDTH surfaces each.
/// launch : 1-D, one work-item per packet          in : albedo[count], irradiance[count], count a multiple of PENCIL_WIDTH
/// out    : scalar[count], packet[count]: radiance; radiosity[count]
kernel void brdf_forms(global const float *albedo, global const float *irradiance, int count, global float *scalar, global float *packet,
                       global float *radiosity) {
    int first = get_global_id(0) * PENCIL_WIDTH;
    if (first >= count) return;
    PACKET_STORE(brdf_reflect_packet(PACKET_LOAD(albedo + first), PACKET_LOAD(irradiance + first)), packet + first);
    for (int i = first; i < first + PENCIL_WIDTH; ++i) {
        scalar[i] = brdf_reflect((float3)(albedo[i]), (float3)(irradiance[i])).y;
        radiosity[i] = brdf_add_radiosity((float4)(0.0f), (float4)(albedo[i]), (float4)(irradiance[i])).z;
    }
}
