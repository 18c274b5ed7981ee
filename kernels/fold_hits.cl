// Completes geometry maps: gutters of the hit atlas, and for every 2x2 footprint what visibility tests need to know first.

#include "lib/map.cl"
#include "lib/triangle.cl"
#include "shared/atlas.h"
#include "shared/geometry.h"

/// Disparity of a whole plane along `direction`, whether it is what is seen there or not.
static inline float plane_disparity(float4 plane, float4 cop, float4 direction) {
    return dot(plane.xyz, direction.xyz) / plane_ahead(plane, cop);
}

/// True if, within a footprint that shows both, surfels on plane a can be hidden by plane b: where b is shown it is the nearer of the two.
/// Where b is shown although it is the farther (a convex edge, or the far side of a silhouette), nothing of a is there: it would be seen.
static inline bool plane_hides(const int *shown, const float4 *planes, const float4 *directions, int a, int b, float4 cop) {
    for (int k = 0; k < 4; ++k)
        if (shown[k] == shown[b] && plane_disparity(planes[b], cop, directions[k]) >= plane_disparity(planes[a], cop, directions[k]))
            return true;
    return false;
}

/// The first triangle of each group of mates that a footprint and the texels next to it show, ascending, with GROUP_INNER where the
/// footprint itself shows one of them; -1 in the places left; CELL_MIXED in x if there are more than MOST_GROUPS.
static inline int4 groups_around(int tile, int2 texel, int n, global const Hit *hits, global const Triangle *triangles) {
    int group[MOST_GROUPS] = {-1, -1, -1, -1}, low[MOST_GROUPS] = {-1, -1, -1, -1}, high[MOST_GROUPS] = {-1, -1, -1, -1};
    int count = 0;
    for (int k = 0; k < AROUND_TEXELS; ++k) {
        int triangle = hits[map_atlas_index(tile, map_texel_around(texel, k, n), n)].triangle;
        if (triangle < 0) continue;
        int inner = texel_is_inner(k) ? GROUP_INNER : 0;
        bool known = false;
        for (int g = 0; g < count; ++g)
            if (triangle >= low[g] && triangle <= high[g]) {
                group[g] |= inner;
                known = true;
            }
        if (known) continue;
        if (count == MOST_GROUPS) return (int4)(CELL_MIXED);
        low[count] = triangle - MATES_BEFORE(triangles[triangle].mates);
        high[count] = triangle + MATES_AFTER(triangles[triangle].mates);
        group[count] = low[count] | inner;
        for (int g = count++; g > 0 && low[g] < low[g - 1]; --g) {
            int4 swap = (int4)(group[g], low[g], high[g], 0);
            group[g] = group[g - 1];
            low[g] = low[g - 1];
            high[g] = high[g - 1];
            group[g - 1] = swap.x;
            low[g - 1] = swap.y;
            high[g - 1] = swap.z;
        }
    }
    return vload4(0, group);
}

/// True if somewhere on the border of the footprint plane t is nearer than both a and b. Disparities are linear along the border's four
/// sides, so t - a and t - b are, and are positive on intervals.
static inline bool reaches_between(float4 t, float4 a, float4 b, const float4 *directions, float4 cop) {
    const int around[5] = {0, 1, 3, 2, 0};
    for (int side = 0; side < 4; ++side) {
        float4 from = directions[around[side]], to = directions[around[side + 1]];
        float2 low = plane_disparity(t, cop, from) - (float2)(plane_disparity(a, cop, from), plane_disparity(b, cop, from));
        float2 high = plane_disparity(t, cop, to) - (float2)(plane_disparity(a, cop, to), plane_disparity(b, cop, to));
        if (fmin(low.x, low.y) > 0.0f || fmin(high.x, high.y) > 0.0f) return true;
        if (fmax(low.x, high.x) <= 0.0f || fmax(low.y, high.y) <= 0.0f) continue;
        // One is positive from its zero onwards, the other up to its zero.
        float rise = low.x <= 0.0f ? low.x / (low.x - high.x) : low.y / (low.y - high.y);
        float fall = low.x <= 0.0f ? low.y / (low.y - high.y) : low.x / (low.x - high.x);
        if (rise <= fall) return true;
    }
    return false;
}

/// Fills the gutter by folding and classifies footprints.   thesis 4.3.1, last paragraph (replicated border texels)
/// launch : 1-D, one work-item per texel of `tile_count` tiles, gutters included
/// in     : triangles, planes, cops; hits, interior texels
/// out    : hits, gutter texels; cells, for the footprint whose first texel this is; groups, groups_around where no plane fills the cell
kernel void fold_hits(global const Triangle *triangles, global const float4 *planes, global const float4 *cops, int first_tile,
                      int tile_count, int n, global Hit *hits, global int2 *cells, global int4 *groups) {
    int item = get_global_id(0);
    int texels = MAP_STORED(n);
    if (item >= tile_count * texels) return;
    int stride = PENCIL_TILE_STRIDE(n);
    int tile = first_tile + item / texels;
    int2 texel = (int2)(item % texels % stride, item % texels / stride) - PENCIL_GUTTER;
    int2 source = map_texel_beside(texel, (int2)(0), n);
    int target = map_atlas_index(tile, texel, n);
    if (texel.x != source.x || texel.y != source.y) hits[target] = hits[map_atlas_index(tile, source, n)];
    if (!map_starts_footprint(texel, n)) return;

    int shown[4];
    bool inside = min(texel.x, texel.y) >= 0 && max(texel.x, texel.y) < n - 1;  // no corner to be folded
    for (int k = 0; k < 4; ++k) {
        int2 corner = (int2)(k & 1, k >> 1);
        int at = inside ? target + corner.y * stride + corner.x : map_atlas_index(tile, map_footprint_texel(texel, k, n), n);
        int triangle = hits[at].triangle;
        shown[k] = triangle < 0 ? -1 : triangles[triangle].plane;
    }
    int a = 0, b = 0, others = 0;
    for (int k = 1; k < 4; ++k)
        if (shown[k] != shown[a]) b = k;
    int2 cell = (int2)(shown[a], shown[b]);
    if (a == b) {  // nearly all of them
        cells[target] = cell;
        groups[target] = (int4)(-1);
        return;
    }
    for (int k = 0; k < 4; ++k) others += shown[k] != shown[a] && shown[k] != shown[b] ? 1 : 0;
    float4 cop = (float4)(cops[tile].xyz, 0.0f), directions[4], plane[4];
    for (int k = 0; k < 4; ++k) {
        plane[k] = planes[max(shown[k], 0)];
        directions[k] = map_texel_direction(map_footprint_texel(texel, k, n), n);
    }
    int4 around = groups_around(tile, texel, n, hits, triangles);
    int near[MOST_GROUPS];
    vstore4(around, 0, near);
    if (others > 0) {
        cell = (int2)(CELL_MIXED);
    } else if (a != b && shown[a] >= 0 && shown[b] >= 0) {
        bool hides_a = plane_hides(shown, plane, directions, a, b, cop);
        bool hides_b = plane_hides(shown, plane, directions, b, a, cop);
        if (hides_a || hides_b) cell.y = CELL_PAIR(shown[b]);
        // Where two walls meet, a third next to them may reach in between the texels: the tip of a sheet that stands in their corner.
        for (int g = 0; g < MOST_GROUPS && hides_a && hides_b; ++g) {
            int third = near[g] < 0 ? -1 : triangles[near[g] & ~GROUP_INNER].plane;
            bool other = third >= 0 && third != shown[a] && third != shown[b];
            if (around.x == CELL_MIXED || (other && reaches_between(planes[third], plane[a], plane[b], directions, cop)))
                cell = (int2)(CELL_MIXED);
        }
    }
    cells[target] = cell;
    groups[target] = around;
}
