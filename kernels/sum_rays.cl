// What surfels reflect of the light that their own rays have found (project_rays.cl), without lines of pencils.

#include "lib/packet.cl"
#include "lib/surfel_packet.cl"
#include "shared/surfel.h"
#include "shared/weights.h"

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH surfels from first_surfel on
/// in     : surfels of `capacity`; rays[ray_count][RAY_FIELDS][ray_capacity]: of the surfels from first_surfel on, which go by the cosine
/// out    : outgoing[3][capacity] [W m^-2 sr^-1], added to
/// E = pi / m sum L over the m rays that found light or saw that there is none; a surfel without such receives nothing.
kernel void sum_rays(global const float *surfels, int capacity, int first_surfel, int surfel_count, global const float *rays,
                     int ray_capacity, int ray_count, global float *outgoing) {
    int offset = get_global_id(0) * PENCIL_WIDTH, first = first_surfel + offset;
    if (first >= surfel_count) return;
    vfloat r = 0.0f, g = 0.0f, b = 0.0f, found = 0.0f;
    for (int k = 0; k < ray_count; ++k) {
        global const float *ray = rays + (size_t)k * RAY_FIELDS * ray_capacity + offset;
        vint known = PACKET_MASK(PACKET_LOAD(ray + (size_t)RAY_RADIUS * ray_capacity) >= 0.0f);
        found += select((vfloat)(0.0f), (vfloat)(1.0f), known);
        r += select((vfloat)(0.0f), PACKET_LOAD(ray + (size_t)RAY_R * ray_capacity), known);
        g += select((vfloat)(0.0f), PACKET_LOAD(ray + (size_t)RAY_G * ray_capacity), known);
        b += select((vfloat)(0.0f), PACKET_LOAD(ray + (size_t)RAY_B * ray_capacity), known);
    }
    vfloat scale = M_PI_F / fmax(found, (vfloat)(1.0f));
    scatter_irradiance(surfels, capacity, first, scale * r, scale * g, scale * b, outgoing, 1);
}
