// Drawing triangles into one facet of a map of several panels: what octant.cl does for the octahedral map, over the shapes of facets that
// cube_facet.cl and pyramid_facet.cl give.

#include "lib/map.cl"
#include "lib/octant.cl"
#include "lib/raster.cl"
#include "lib/triangle.cl"
#include "shared/cluster.h"
#include "shared/geometry.h"

/// One facet of one tile.
typedef struct PanelFacet {
    FacetShape shape;
    int facet, n;
    float4 cop;
    global Hit *panel;  // texel (0, 0)
} PanelFacet;

/// Facet number `item` % MAP_FACETS of tile `item` / MAP_FACETS behind first_tile, cleared.
static inline PanelFacet panel_facet_begin(int item, global const float4 *cops, int first_tile, int n, global Hit *hits) {
    int index = first_tile + item / MAP_FACETS;
    PanelFacet f;
    f.facet = item % MAP_FACETS;
    f.shape = PANEL(facet)(f.facet);
    f.n = n;
    f.cop = (float4)(cops[index].xyz, 0.0f);
    f.panel = hits + (size_t)index * MAP_STORED(n) + map_atlas_index(0, texel_of_panel((int2)(0), f.shape.panel, n), n);
    for (int y = 0; y < n; ++y) {
        int2 row = PANEL(facet_row)(f.facet, y, n);
        for (int x = row.x; x <= row.y; ++x) {
            f.panel[y * PENCIL_TILE_STRIDE(n) + x].triangle = -1;
            f.panel[y * PENCIL_TILE_STRIDE(n) + x].disparity = 0.0f;
        }
    }
    return f;
}

/// Keeps the part of a polygon on the inner side of a plane through the centre. Returns its number of corners.
static inline int clip_by_side(const float4 *in, int count, float4 side, float4 *out) {
    int kept = 0;
    for (int i = 0; i < count; ++i) {
        float4 p = in[i], q = in[i + 1 < count ? i + 1 : 0];
        float dp = dot(p.xyz, side.xyz), dq = dot(q.xyz, side.xyz);
        if (dp >= 0.0f) out[kept++] = p;
        if ((dp < 0.0f) != (dq < 0.0f)) out[kept++] = p + (q - p) * (dp / (dp - dq));
    }
    return kept;
}

/// (u, v) of a point; `depth`: dot(depth, p) > 0.
static inline float2 facet_point(const FacetShape *f, float4 p, float depth) {
    return (float2)(dot(f->u.xyz, p.xyz), dot(f->v.xyz, p.xyz)) / depth;
}

/// Bounds (min u, min v, max u, max v) of the part of a triangle in the facet; min > max if none lies in it.
static inline float4 facet_bounds(const FacetShape *f, float4 p0, float4 p1, float4 p2) {
    float4 a[CLIP_CORNERS] = {p0, p1, p2}, b[CLIP_CORNERS];
    int count = 3;
    for (int k = 0; k < FACET_SIDES; k += 2) {
        count = clip_by_side(a, count, f->sides[k], b);
        count = clip_by_side(b, count, f->sides[k + 1], a);
    }
    float4 bounds = (float4)(1, 1, -1, -1);
    for (int i = 0; i < count; ++i) {
        float depth = dot(f->depth.xyz, a[i].xyz);
        if (depth < BOX_TRUSTED_DISTANCE) return (float4)(-1, -1, 1, 1);
        float2 point = facet_point(f, a[i], depth);
        bounds = (float4)(fmin(bounds.xy, point), fmax(bounds.zw, point));
    }
    return bounds;
}

/// Texels of the panel between `low` and `high`, coordinates in [-1, 1] along one side.
static inline int2 facet_range(float low, float high, int n) {
    return raster_range((low + 1.0f) * (0.5f * n), (high + 1.0f) * (0.5f * n), BOX_SLACK, n - 1);
}

/// Those of row y that belong to the facet.
static inline int2 facet_columns(const PanelFacet *f, int2 columns, int y) {
    int2 row = PANEL(facet_row)(f->facet, y, f->n);
    return (int2)(max(columns.x, row.x), min(columns.y, row.y));
}

/// Draws triangle i.
static inline void panel_facet_draw(const PanelFacet *f, global const Triangle *triangles, global const float4 *planes, int i) {
    global const Triangle *triangle = triangles + i;
    float4 p0 = triangle->v0 - f->cop, p1 = triangle->v1 - f->cop, p2 = triangle->v2 - f->cop;
    for (int k = 0; k < FACET_SIDES; ++k) {
        float3 side = f->shape.sides[k].xyz;
        if (fmax(fmax(dot(p0.xyz, side), dot(p1.xyz, side)), dot(p2.xyz, side)) < 0.0f) return;
    }
    float4 plane = planes[triangle->plane];
    float ahead = plane_ahead(plane, f->cop);
    if (fabs(ahead) < PLANE_TOLERANCE) return;
    float4 bounds = facet_bounds(&f->shape, p0, p1, p2);
    if (bounds.x > bounds.z) return;
    RasterTriangle t = raster_setup(p0, p1, p2, plane, ahead, f->shape.frame);
    int2 columns = facet_range(bounds.x, bounds.z, f->n), rows = facet_range(bounds.y, bounds.w, f->n);
    float du = 2.0f / f->n, u0 = 1.0f / f->n - 1.0f;
    for (int y = rows.x; y <= rows.y; ++y) {
        int2 row = facet_columns(f, columns, y);
        raster_row(&t, i, u0, du, u0 + y * du, row.x, row.y, INFINITY, f->panel + y * PENCIL_TILE_STRIDE(f->n));
    }
}

/// False if the part of the box in the facet holds no texel's centre, or lies behind all that those texels show.
static inline bool panel_facet_matters(const PanelFacet *f, global const Cluster *cluster) {
    float4 low = cluster->low - f->cop, high = cluster->high - f->cop;
    for (int k = 0; k < FACET_SIDES; ++k) {
        float4 most = fmax(f->shape.sides[k] * low, f->shape.sides[k] * high);
        if (most.x + most.y + most.z < 0.0f) return false;
    }
    float4 least = fmin(f->shape.depth * low, f->shape.depth * high);
    float distance = least.x + least.y + least.z;
    if (distance < BOX_TRUSTED_DISTANCE) return true;
    float2 first = (float2)(1.0f), last = (float2)(-1.0f);
    for (int corner = 0; corner < 8; ++corner) {
        float4 p = (float4)(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z, 0.0f);
        float2 point = facet_point(&f->shape, p, dot(f->shape.depth.xyz, p.xyz));
        first = fmin(first, point);
        last = fmax(last, point);
    }
    int2 columns = facet_range(first.x, last.x, f->n), rows = facet_range(first.y, last.y, f->n);
    for (int y = rows.x; y <= rows.y; ++y) {
        int2 row = facet_columns(f, columns, y);
        for (int x = row.x; x <= row.y; ++x)
            if (f->panel[y * PENCIL_TILE_STRIDE(f->n) + x].disparity <= (1.0f + DISPARITY_SLACK) / distance) return true;
    }
    return false;
}
