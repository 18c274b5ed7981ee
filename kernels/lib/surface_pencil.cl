// Local projection: whether, and how well, the irradiance of a surface pencil stands for that of a surface point near it (Ward, Rubinstein
// and Clear 1988, with the horizon of the pencil against light through walls).

#include "lib/hemisphere.cl"
#include "shared/geometry.h"
#include "shared/surface_pencil.h"

/// Normals further apart than this cosine are not interpolated.
#define REUSE_LEAST_COSINE 0.5f
/// A point may lie above or below the pencil's surface by this share of its distance.
#define REUSE_MOST_SLOPE 0.4f
/// Weight of the turn of the normal against the step in position.
#define REUSE_TURN 0.5f

/// Distances below this are 0 at x: rounding of positions [scene units].
static inline float position_error(float3 x) { return POSITION_ERROR * fmax(fabs(x.x), fmax(fabs(x.y), fabs(x.z))); }

/// True if nothing at the horizon of the pencil lies between it and the point at `step` from it.
static inline bool clear_horizon(global const SurfacePencil *p, float3 step) {
    float3 t, b;
    tangent_frame(p->normal.xyz, &t, &b);
    float x = dot(step, t), y = dot(step, b);
    int sector = ring_sector(x, y);
    int next = sector + RING_SECTORS;
    return fmax(x * p->horizon_x[sector] + y * p->horizon_y[sector], x * p->horizon_x[next] + y * p->horizon_y[next]) < 1.0f;
}

/// Distance from the pencil to x if it is at most `most` and the pencil's irradiance may be used there, INFINITY otherwise.
static inline float reuse_distance(global const SurfacePencil *p, float3 x, float3 n, float most) {
    float3 step = x - p->position.xyz;
    float square = dot(step, step);
    if (square > most * most) return INFINITY;
    float3 normal = p->normal.xyz;
    if (dot(normal, n) < REUSE_LEAST_COSINE) return INFINITY;
    float distance = sqrt(square);
    if (distance < position_error(x)) return 0.0f;
    if (fabs(dot(step, normal + n)) > 2.0f * REUSE_MOST_SLOPE * distance) return INFINITY;
    return clear_horizon(p, step) ? distance : INFINITY;
}

/// Ward's estimate of the relative change of irradiance from the pencil to a point at `distance` from it with normal n.
static inline float reuse_error(global const SurfacePencil *p, float distance, float3 n) {
    return distance / p->facing.w + REUSE_TURN * sqrt(fmax(1.0f - dot(p->normal.xyz, n), 0.0f));
}
