// Drawing triangles into one octant of an octahedral tile (thesis 4.3.1, table 4.2 with the flip 4.17).

#include "lib/octahedral.cl"
#include "lib/raster.cl"
#include "lib/triangle.cl"
#include "shared/atlas.h"
#include "shared/cluster.h"
#include "shared/geometry.h"

/// Octants of a tile: a work-item each.
#define OCTANTS 8
/// Room for the corners of a triangle clipped by three planes, of panels by four: each adds one at most, and rounding one more.
#define CLIP_CORNERS (PENCIL_MAP_KIND == 0 ? 7 : 11)

/// Direction through (u, v) in the octant of signs s: inside the diamond (u, v, 1 - sx u - sy v); outside it
/// (sx - sx sy v, sy - sx sy u, 1 - sx u - sy v), which is the flip of eq. (4.17).
static inline RasterFrame octant_frame(float3 s) {
    RasterFrame f;
    float sxy = s.x * s.y;
    bool front = s.z > 0.0f;
    f.origin = front ? (float4)(0, 0, 1, 0) : (float4)(s.x, s.y, 1, 0);
    f.du = front ? (float4)(1, 0, -s.x, 0) : (float4)(0, -sxy, -s.x, 0);
    f.dv = front ? (float4)(0, 1, -s.y, 0) : (float4)(-sxy, 0, -s.y, 0);
    return f;
}

/// Keeps the part of a polygon with a non-negative component `axis`. Returns its number of corners.
static inline int clip_polygon(const float4 *in, int count, int axis, float4 *out) {
    int kept = 0;
    for (int i = 0; i < count; ++i) {
        float4 p = in[i];
        float4 q = in[i + 1 < count ? i + 1 : 0];
        float dp = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
        float dq = axis == 0 ? q.x : axis == 1 ? q.y : q.z;
        if (dp >= 0.0f) out[kept++] = p;
        if ((dp < 0.0f) != (dq < 0.0f)) out[kept++] = p + (q - p) * (dp / (dp - dq));
    }
    return kept;
}

/// Bounds of |x| / W and |y| / W over the part of the triangle in the octant, corners given with the octant's signs taken out:
/// (min x, min y, max x, max y); min > max if no part lies in it.
static inline float4 octant_bounds(float4 p0, float4 p1, float4 p2) {
    float4 a[CLIP_CORNERS] = {p0, p1, p2}, b[CLIP_CORNERS];
    int count = 3;
    float4 low = fmin(fmin(p0, p1), p2);
    if (fmin(fmin(low.x, low.y), low.z) < 0.0f) {
        count = clip_polygon(a, count, 0, b);
        count = clip_polygon(b, count, 1, a);
        count = clip_polygon(a, count, 2, b);
        for (int i = 0; i < count; ++i) a[i] = b[i];
    }
    float4 bounds = (float4)(1, 1, 0, 0);
    for (int i = 0; i < count; ++i) {
        float norm = fabs(a[i].x) + fabs(a[i].y) + fabs(a[i].z);
        if (norm < BOX_TRUSTED_DISTANCE) return (float4)(0, 0, 1, 1);
        float2 q = a[i].xy / norm;
        bounds = (float4)(fmin(bounds.xy, q), fmax(bounds.zw, q));
    }
    return bounds;
}

/// Draws one triangle into one octant of one tile.
static inline void raster_octant(RasterTriangle t, float4 bounds, float3 s, int triangle, int n, global Hit *tile) {
    int half_n = n / 2;
    // Rings count texels from the axes outwards: |u| = (2 k + 1) / n. Outside the diamond |u| = 1 - |y|/W and |v| = 1 - |x|/W.
    float4 uv = s.z > 0.0f ? bounds : 1.0f - bounds.wzyx;
    int2 ku = raster_range(uv.x * half_n, uv.z * half_n, BOX_SLACK, half_n - 1);
    int2 kv = raster_range(uv.y * half_n, uv.w * half_n, BOX_SLACK, half_n - 1);
    float du = 2.0f / n;
    float u0 = 1.0f / n - 1.0f;
    for (int k = kv.x; k <= kv.y; ++k) {
        // Centres with |u| + |v| <= 1 belong to the front octant; those on the diagonal have z = 0 and both projections agree.
        int k0 = s.z > 0.0f ? ku.x : max(ku.x, half_n - k);
        int k1 = s.z > 0.0f ? min(ku.y, half_n - 1 - k) : ku.y;
        int y = s.y > 0.0f ? half_n + k : half_n - 1 - k;
        int first = s.x > 0.0f ? half_n + k0 : half_n - 1 - k1;
        int last = s.x > 0.0f ? half_n + k1 : half_n - 1 - k0;
        raster_row(&t, triangle, u0, du, u0 + y * du, first, last, INFINITY, tile + oct_atlas_index(0, (int2)(0, y), n));
    }
}

/// Clears the texels of one octant.
static inline void clear_octant(float3 s, int n, global Hit *tile) {
    int half_n = n / 2;
    for (int ky = 0; ky < half_n; ++ky)
        for (int kx = 0; kx < half_n; ++kx) {
            if ((kx + ky < half_n) != (s.z > 0.0f)) continue;
            int2 texel = (int2)(s.x > 0.0f ? half_n + kx : half_n - 1 - kx, s.y > 0.0f ? half_n + ky : half_n - 1 - ky);
            global Hit *hit = tile + oct_atlas_index(0, texel, n);
            hit->triangle = -1;
            hit->disparity = 0.0f;
        }
}

/// One octant of one tile.
typedef struct Octant {
    float3 s;  // signs of the directions
    int n;
    float4 cop;
    RasterFrame frame;
    global Hit *tile;
} Octant;

/// Octant `item` % OCTANTS of tile `item` / OCTANTS behind first_tile, cleared.
static inline Octant octant_begin(int item, global const float4 *cops, int first_tile, int n, global Hit *hits) {
    int octant = item % OCTANTS, index = first_tile + item / OCTANTS;
    Octant o;
    o.s = (float3)(octant & 1 ? -1.0f : 1.0f, octant & 2 ? -1.0f : 1.0f, octant & 4 ? -1.0f : 1.0f);
    o.n = n;
    o.cop = (float4)(cops[index].xyz, 0.0f);
    o.frame = octant_frame(o.s);
    o.tile = hits + (size_t)index * PENCIL_TILE_TEXELS(n);
    clear_octant(o.s, n, o.tile);
    return o;
}

/// Draws triangle i.
static inline void octant_draw(const Octant *o, global const Triangle *triangles, global const float4 *planes, int i) {
    global const Triangle *triangle = triangles + i;
    float4 s = (float4)(o->s, 0.0f), cop = o->cop;
    float4 p0 = triangle->v0 - cop, p1 = triangle->v1 - cop, p2 = triangle->v2 - cop;
    float4 high = fmax(fmax(p0 * s, p1 * s), p2 * s);
    if (high.x < 0.0f || high.y < 0.0f || high.z < 0.0f) return;
    float4 plane = planes[triangle->plane];
    float ahead = plane_ahead(plane, cop);
    if (fabs(ahead) < PLANE_TOLERANCE) return;
    float4 bounds = octant_bounds(p0 * s, p1 * s, p2 * s);
    if (bounds.x > bounds.z) return;
    raster_octant(raster_setup(p0, p1, p2, plane, ahead, o->frame), bounds, o->s, i, o->n, o->tile);
}

/// True if a texel of rings ku, kv (ranges) of the octant shows nothing nearer than `disparity`.
static inline bool octant_shows(const Octant *o, int2 ku, int2 kv, float disparity) {
    int half_n = o->n / 2;
    for (int k = kv.x; k <= kv.y; ++k) {
        int k0 = o->s.z > 0.0f ? ku.x : max(ku.x, half_n - k);
        int k1 = o->s.z > 0.0f ? min(ku.y, half_n - 1 - k) : ku.y;
        int y = o->s.y > 0.0f ? half_n + k : half_n - 1 - k;
        int first = o->s.x > 0.0f ? half_n + k0 : half_n - 1 - k1;
        global const Hit *row = o->tile + oct_atlas_index(0, (int2)(first, y), o->n);
        for (int x = 0; x <= k1 - k0; ++x)
            if (row[x].disparity <= disparity) return true;
    }
    return false;
}

/// False if the part of the box in the octant holds no texel's centre, or lies behind all that those texels show.
static inline bool octant_matters(const Octant *o, global const Cluster *cluster) {
    float4 s = (float4)(o->s, 0.0f);
    float4 a = (cluster->low - o->cop) * s, b = (cluster->high - o->cop) * s;
    float4 high = fmax(a, b);
    if (high.x < 0.0f || high.y < 0.0f || high.z < 0.0f) return false;
    float4 low = fmax(fmin(a, b), 0.0f);
    float distance = low.x + low.y + low.z;
    if (distance < BOX_TRUSTED_DISTANCE) return true;
    // |x| / W grows with |x| and falls with |y| and |z|: its bounds over a box are at corners.
    float4 uv = (float4)(low.x / (low.x + high.y + high.z), low.y / (high.x + low.y + high.z), high.x / (high.x + low.y + low.z),
                         high.y / (low.x + high.y + low.z));
    if (o->s.z < 0.0f) uv = 1.0f - uv.wzyx;
    int half_n = o->n / 2;
    int2 ku = raster_range(uv.x * half_n, uv.z * half_n, BOX_SLACK, half_n - 1);
    int2 kv = raster_range(uv.y * half_n, uv.w * half_n, BOX_SLACK, half_n - 1);
    return octant_shows(o, ku, kv, (1.0f + DISPARITY_SLACK) / distance);
}
