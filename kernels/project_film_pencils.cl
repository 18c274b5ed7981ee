// Local projection to the film: every surfel takes its irradiance from the film pencils at the lattice points about its pixel.

#include "lib/brdf.cl"
#include "lib/film_lattice.cl"
#include "lib/hemisphere.cl"
#include "lib/surface_pencil.cl"
#include "shared/film.h"
#include "shared/surface_pencil.h"
#include "shared/surfel.h"

/// Errors below this share of most_error count as this: a pencil at the surfel itself has a finite weight.
#define FILM_LEAST_ERROR 0.02f
/// Squared distance that the normals' 1 - cosine counts as, among pencils that may not be used, in terms of the square of the distance to the
/// eye: likeness of normals first.
#define FILM_TURN 0.25f

/// What smooth_irradiance says at `step` from the pencil.
static inline float3 fitted_irradiance(global const float4 *fit, global const SurfacePencil *pencil, float3 step) {
    float3 t, b;
    tangent_frame(pencil->normal.xyz, &t, &b);
    return fmax(fit[0].xyz + dot(step, t) * fit[1].xyz + dot(step, b) * fit[2].xyz, (float3)(0.0f));
}

/// Scattering K of the irradiance of surfel i, added to outgoing[3][capacity].
static inline void add_reflected(global const float *surfels, size_t capacity, int i, float3 irradiance, global float *outgoing) {
    global const float *s = surfels + i;
    float3 albedo = (float3)(s[SURFEL_ALBEDO_R * capacity], s[SURFEL_ALBEDO_G * capacity], s[SURFEL_ALBEDO_B * capacity]);
    float3 radiance = brdf_reflect(albedo, irradiance);
    outgoing[i] += radiance.x;
    outgoing[capacity + i] += radiance.y;
    outgoing[2 * capacity + i] += radiance.z;
}

/// launch : 1-D, one work-item per pixel
/// in     : as cover_film; most_error: reuse_error at which a pencil's weight falls to 0; single_irradiance, single_at[capacity]: of the
///          pencil that stands for this surfel alone, -1: none
/// out    : outgoing[3][capacity] [W m^-2 sr^-1] of the pixel's surfels, added to
kernel void project_film_pencils(global const float *surfels, int capacity, global const uchar *counts, global const int *first_surfel,
                                 global const SurfacePencil *pencils, global const float4 *fits, global const int *pencil_at, int coarsest,
                                 int finest, float most_error, global const float4 *single_irradiance, global const int *single_at,
                                 int width, int height, global float *outgoing) {
    int pixel = get_global_id(0);
    if (pixel >= width * height) return;
    int2 at = (int2)(pixel % width, pixel / width);
    for (int k = 0; k < (counts[pixel] & FILM_COUNT_MASK); ++k) {
        int i = first_surfel[pixel] + k;
        if (single_at[i] >= 0) {
            add_reflected(surfels, capacity, i, single_irradiance[single_at[i]].xyz, outgoing);
            continue;
        }
        SurfacePoint point = surface_point(surfels, capacity, i);
        float4 sum = (float4)(0.0f), last = (float4)(0.0f);
        float least = INFINITY;
        for (int spacing = coarsest; spacing >= finest; spacing /= 2)
            for (int corner = 0; corner < LATTICE_CORNERS; ++corner) {
                int index = lattice_pencil(pencil_at, at, spacing, coarsest, corner, width, height);
                if (index < 0) continue;
                global const SurfacePencil *pencil = pencils + index;
                float distance = reuse_distance(pencil, point.x, point.n, INFINITY);
                float error = distance < INFINITY ? fmax(reuse_error(pencil, distance, point.n), FILM_LEAST_ERROR * most_error) : INFINITY;
                int2 apart = convert_int2(abs_diff(lattice_pixel(at, spacing, corner, width, height), at));
                float tent = fmax(1.0f - apart.x / (float)spacing, 0.0f) * fmax(1.0f - apart.y / (float)spacing, 0.0f);
                float weight = fmax(1.0f / error - 1.0f / most_error, 0.0f) * tent;
                float3 step = point.x - pencil->position.xyz;
                if (weight > 0.0f) sum += weight * (float4)(fitted_irradiance(fits + 3 * (size_t)index, pencil, step), 1.0f);
                // No pencil reaches: take the most similar one.
                float unlike = dot(step, step) + (1.0f - dot(pencil->normal.xyz, point.n)) * FILM_TURN * dot(point.x, point.x);
                if (unlike < least) {
                    least = unlike;
                    last = (float4)(fits[3 * (size_t)index].xyz, 1.0f);
                }
            }
        if (sum.w <= 0.0f) sum = last;
        if (sum.w <= 0.0f) continue;
        add_reflected(surfels, capacity, i, sum.xyz / sum.w, outgoing);
    }
}
