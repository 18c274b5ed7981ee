// Irradiance of film pencils, each fitted with its neighbours on the lattice: a linear function of position, so that slopes stay and noise
// averages out.

#include "lib/film_lattice.cl"
#include "lib/hemisphere.cl"
#include "lib/surface_pencil.cl"
#include "shared/surface_pencil.h"

/// Neighbours to each side.
#define SMOOTH_REACH 3
/// Share of the neighbours' weight that holds slopes at 0: decides where neighbours lie on one side or in a line.
#define SMOOTH_HOLD 1e-3f
/// Where all neighbours lie in one point, the rounding of positions holds them, at least this share of the mean distance of what is seen:
/// keeps the determinant above 0, and in float.
#define SMOOTH_TINY 1e-6f

/// A film pencil's irradiance near it: value + along_t dot(step, t) + along_b dot(step, b), t and b of tangent_frame.
/// launch : 1-D, one work-item per pixel
/// in     : pencils, their irradiance, pencil_at; most_error: reuse_error at which a neighbour counts nothing
/// out    : fits[3 * pencil ..]: value, along_t, along_b (rgb) [W m^-2, W m^-2 / scene unit]
kernel void smooth_irradiance(global const SurfacePencil *pencils, global const float4 *irradiance, global const int *pencil_at,
                              float most_error, int width, int height, global float4 *fits) {
    int pixel = get_global_id(0);
    if (pixel >= width * height || pencil_at[pixel] < 0) return;
    global const SurfacePencil *own = pencils + pencil_at[pixel];
    int2 at = (int2)(pixel % width, pixel / width);
    int spacing = own->spacing;
    float3 x = own->position.xyz, n = own->normal.xyz, t, b;
    tangent_frame(n, &t, &b);
    // In units of the pencil's reach: neighbours lie within it, whatever the scale of the scene.
    float unit = fmax(own->facing.w, FLT_MIN);
    // Sums of weights, of (s, u) and the irradiance, and of their products.
    float w = 0.0f, ws = 0.0f, wu = 0.0f, wss = 0.0f, wsu = 0.0f, wuu = 0.0f;
    float3 e0 = (float3)(0.0f), es = (float3)(0.0f), eu = (float3)(0.0f);
    for (int dy = -SMOOTH_REACH; dy <= SMOOTH_REACH; ++dy)
        for (int dx = -SMOOTH_REACH; dx <= SMOOTH_REACH; ++dx) {
            int neighbour = lattice_neighbour(at, (int2)(dx, dy), spacing, width, height);
            int index = neighbour < 0 ? -1 : pencil_at[neighbour];
            if (index < 0) continue;
            global const SurfacePencil *pencil = pencils + index;
            float distance = reuse_distance(pencil, x, n, INFINITY);
            if (distance == INFINITY) continue;
            float error = reuse_error(pencil, distance, n) + reuse_error(own, distance, n);
            float weight = fmax(1.0f - error / (2.0f * most_error), 0.0f);
            float3 step = pencil->position.xyz - x, e = irradiance[index].xyz;
            float s = dot(step, t) / unit, u = dot(step, b) / unit;
            w += weight;
            ws += weight * s;
            wu += weight * u;
            wss += weight * s * s;
            wsu += weight * s * u;
            wuu += weight * u * u;
            e0 += weight * e;
            es += weight * s * e;
            eu += weight * u * e;
        }
    // Least squares about the weighted mean.
    float ms = ws / w, mu = wu / w;
    float ss = wss - ms * ws, su = wsu - ms * wu, uu = wuu - mu * wu;
    float tiny = fmax(position_error(x) / unit, SMOOTH_TINY), hold = SMOOTH_HOLD * (ss + uu) + w * tiny * tiny;
    ss += hold;
    uu += hold;
    float3 mean = e0 / w, cs = es - ms * e0, cu = eu - mu * e0;
    float determinant = ss * uu - su * su;
    float3 along_t = (uu * cs - su * cu) / determinant, along_b = (ss * cu - su * cs) / determinant;
    global float4 *fit = fits + 3 * (size_t)pencil_at[pixel];
    fit[0] = (float4)(fmax(mean - ms * along_t - mu * along_b, (float3)(0.0f)), 0.0f);
    fit[1] = (float4)(along_t / unit, 0.0f);
    fit[2] = (float4)(along_b / unit, 0.0f);
}
