// One bounce between surface pencils: P = Q K R on a fixed set, in terms of irradiance.

#include "lib/brdf.cl"
#include "shared/surfel.h"

/// Surfaces reflect no more than they receive, but few chains of lobes (follow_surfels.cl) may say so by chance. Bounces of pencils that then
/// seem to gain would grow without end.
#define TRANSPORT_MOST 0.995f

/// launch : 1-D, one work-item per pencil
/// in     : surfels (albedo), links, factors: n x n entries per pencil; source[pencil_count]: irradiance of order k
/// in/out : target[pencil_count]: irradiance of order k + 1 is added; total[pencil_count]: target is added
kernel void transport_irradiance(global const float *surfels, int capacity, global const int4 *links, global const float4 *factors,
                                 int pencil_count, int n, global const float4 *source, global float4 *target, global float4 *total) {
    int pencil = get_global_id(0);
    if (pencil >= pencil_count) return;
    size_t c = capacity;
    float4 sum = (float4)(0.0f);
    float weight = 0.0f;
    for (int i = pencil * n * n; i < (pencil + 1) * n * n; ++i) {
        int4 link = links[i];
        if (link.x < 0) continue;
        float4 f = factors[i];
        float4 e = f.x * source[link.x];
        if (link.y >= 0) e += f.y * source[link.y];
        if (link.z >= 0) e += f.z * source[link.z];
        if (link.w >= 0) e += f.w * source[link.w];
        global const float *s = surfels + i;
        if (PENCIL_LOBES) weight += fmax(s[SURFEL_ALBEDO_R * c], fmax(s[SURFEL_ALBEDO_G * c], s[SURFEL_ALBEDO_B * c]));
        sum = brdf_add_radiosity(sum, (float4)(s[SURFEL_ALBEDO_R * c], s[SURFEL_ALBEDO_G * c], s[SURFEL_ALBEDO_B * c], 0.0f), e);
    }
    if (PENCIL_LOBES) sum *= fmin(1.0f, TRANSPORT_MOST * n * n / fmax(weight, 1e-30f));
    // E' = pi / n^2 sum(radiosity / pi)
    sum = sum / (float)(n * n) + target[pencil];
    target[pencil] = sum;
    total[pencil] += sum;
}
