// Irradiance of surface pencils that guided rays carry (guide_hemispheres.cl).

#include "shared/spot.h"

/// launch : 1-D, one work-item per pencil of first_pencil ..
/// in     : radiance[3][capacity] along the rays, `rays` per pencil, SPOT_RAYS from each of the places that it looks from; factors: of each ray [sr]
/// in/out : irradiance[first_pencil ..]: the mean over these places of the sum of factor * radiance is added [W m^-2]
kernel void sum_guides(global const float *radiance, int capacity, global const float *factors, int rays, int first_pencil,
                       int pencil_count, global float4 *irradiance) {
    int item = get_global_id(0);
    if (item >= pencil_count) return;
    float3 sum = (float3)(0.0f);
    for (int i = item * rays; i < (item + 1) * rays; ++i)
        sum += factors[i] * (float3)(radiance[i], radiance[(size_t)capacity + i], radiance[2 * (size_t)capacity + i]);
    irradiance[first_pencil + item] += (float4)(sum * ((float)SPOT_RAYS / rays), 0.0f);
}
