// Analytic density of pencils per direction. A surface point sees a pencil in the directions of a cone if its centre lies in the cone and
// before the next surface. For n centres uniform in the free volume the density per solid angle is p = n d^3 / (3 volume), d the free path
// of the line through pencil and point. Both ends of the line stand in the pencil's own map, at a texel and at its antipode.

#include "lib/balance.cl"
#include "lib/map.cl"
#include "shared/geometry.h"
#include "shared/weights.h"

/// Share of a uniform density over the hemisphere that is added to p, relative to n pencils.
#define UNIFORM_SHARE 0.02f

/// Euclidean distance from cop to what a texel sees, or to where the ray leaves the box in which centres lie.
static inline float free_distance(Hit hit, float4 cop, float4 direction, float4 low, float4 high) {
    float3 ends = select(low.xyz, high.xyz, direction.xyz > 0.0f) - cop.xyz;
    float3 exits = select(ends / direction.xyz, (float3)(MAXFLOAT), direction.xyz == 0.0f);
    float end = fmax(fmin(exits.x, fmin(exits.y, exits.z)), 0.0f);
    if (hit.triangle >= 0) end = fmin(end, 1.0f / hit.disparity);
    return length(direction.xyz) * end;
}

/// launch : 1-D, one work-item per texel of `tile_count` tiles from first_tile
/// in     : hits, cops of tiles of n x n; low, high: box in which centres lie; volume: of its part in which they may lie
/// out    : radiance, atlas layout, w of interior texels: 1 / (p / n + UNIFORM_SHARE / (2 pi)); for PENCIL_WEIGHTS_POWER the path alone, from
///          the centre to where the light of the texel comes from
/// DEVIATION: no directions are drawn from the uniform density. It only keeps the weights bounded where a wall is near: d^3 tends to 0.
kernel void free_path_density(global const Hit *hits, global const float4 *cops, int first_tile, int tile_count, int n, float4 low,
                              float4 high, float volume, global float4 *radiance) {
    int i = get_global_id(0);
    if (i >= tile_count * MAP_TEXELS(n)) return;
    int tile = first_tile + i / MAP_TEXELS(n);
    int2 texel = map_texel_of_row(i % n, i / n % (MAP_PANELS * n), n), behind = map_antipode(texel, n);
    float4 cop = cops[tile], direction = map_texel_direction(texel, n);
    int at = map_atlas_index(tile, texel, n);
    float before = free_distance(hits[map_atlas_index(tile, behind, n)], cop, -direction, low, high);
    if (PENCIL_WEIGHTS == PENCIL_WEIGHTS_POWER) {
        radiance[at].w = before;
        return;
    }
    float density = FREE_PATH_DENSITY(free_distance(hits[at], cop, direction, low, high) + before, volume);
    radiance[at].w = 1.0f / (density + UNIFORM_SHARE / (2.0f * M_PI_F));
}
