// The forms of reflection of irradiance (brdf.cl) by themselves.

#include "lib/brdf.cl"
#include "lib/packet.cl"

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
