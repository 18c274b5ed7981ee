// Copies some surfels, as if they were white: what they reflect is then their irradiance over pi.

#include "shared/surfel.h"

/// launch : 1-D, one work-item per picked surfel
/// in     : surfels[fields][capacity]; list[count]: their numbers
/// out    : picked[fields][picked_capacity], albedo 1
kernel void pick_surfels(global const float *surfels, int capacity, int fields, global const int *list, int count, global float *picked,
                         int picked_capacity) {
    int k = get_global_id(0);
    if (k >= count) return;
    for (int f = 0; f < fields; ++f) {
        bool albedo = f >= SURFEL_ALBEDO_R && f <= SURFEL_ALBEDO_B;
        SURFEL_INT(picked, (size_t)f * picked_capacity + k) =
            albedo ? as_int(1.0f) : SURFEL_CONST_INT(surfels, (size_t)f * capacity + list[k]);
    }
}
