// Core of the triangle rasteriser. In each facet of a map, and on the film, the direction is affine in the texel
// coordinates (thesis eq. (4.14), tables 4.1 and 4.2), hence so are the three edge functions of a triangle and its disparity: no clipping
// decides coverage, only signs at texel centres.

#include "lib/packet.cl"
#include "lib/triangle.cl"
#include "shared/geometry.h"

/// Edge functions (x, y, z) and disparity (w) of one triangle as affine functions a u + b v + c.
typedef struct RasterTriangle {
    float4 a, b, c;
} RasterTriangle;

/// Direction as an affine function of (u, v): origin + u du + v dv.
typedef struct RasterFrame {
    float4 origin, du, dv;
} RasterFrame;

/// A facet of a map with several panels, where the projection is linear: a point p has the coordinates (dot(u, p), dot(v, p)) / dot(depth, p) in
/// `panel`, and lies dot(depth, p) times as far as the end of the direction that `frame` gives them.
#define FACET_SIDES 4
typedef struct FacetShape {
    int panel;
    RasterFrame frame;
    float4 depth, u, v;
    float4 sides[FACET_SIDES];  // normals, inwards, of the planes through the centre that bound the facet
} FacetShape;

/// Composes edge functions and disparity with the frame. `ahead` is plane_ahead of the centre of projection, not within rounding of 0.
/// Seen from the back a triangle's edge functions turn their sign, as `ahead` does.
static inline RasterTriangle raster_setup(float4 p0, float4 p1, float4 p2, float4 plane, float ahead, RasterFrame frame) {
    float side = ahead > 0.0f ? 1.0f : -1.0f;
    float3 e0 = edge_normal(p0, p1).xyz * side;
    float3 e1 = edge_normal(p1, p2).xyz * side;
    float3 e2 = edge_normal(p2, p0).xyz * side;
    float3 w = plane.xyz / ahead;
    float3 o = frame.origin.xyz, du = frame.du.xyz, dv = frame.dv.xyz;
    RasterTriangle t;
    t.a = (float4)(dot(e0, du), dot(e1, du), dot(e2, du), dot(w, du));
    t.b = (float4)(dot(e0, dv), dot(e1, dv), dot(e2, dv), dot(w, dv));
    t.c = (float4)(dot(e0, o), dot(e1, o), dot(e2, o), dot(w, o));
    return t;
}

/// Draws texels first..last of one row: u of texel x is u0 + x * du. `row` points at texel 0. What has a larger disparity than `nearest` is
/// not there (INFINITY: all is). Larger disparity wins; at equal disparity the lower triangle index (documented tie).
static inline void raster_row(const RasterTriangle *t, int triangle, float u0, float du, float v, int first, int last, float nearest,
                              global Hit *row) {
    float4 base = t->b * v + t->c;
    for (int x = first; x <= last; x += PENCIL_WIDTH) {
        vint lane = x + PACKET_LANES;
        vfloat u = fma(PACKET_TO_FLOAT(lane), (vfloat)(du), (vfloat)(u0));
        vfloat e0 = fma((vfloat)(t->a.x), u, (vfloat)(base.x));
        vfloat e1 = fma((vfloat)(t->a.y), u, (vfloat)(base.y));
        vfloat e2 = fma((vfloat)(t->a.z), u, (vfloat)(base.z));
        vfloat w = fma((vfloat)(t->a.w), u, (vfloat)(base.w));
        vint covered = PACKET_MASK(fmin(fmin(e0, e1), e2) >= 0.0f) & PACKET_MASK(w > 0.0f) & PACKET_MASK(lane <= last);
        if (!PACKET_ANY(covered)) continue;
        int inside[PENCIL_WIDTH];
        float disparity[PENCIL_WIDTH];
        PACKET_STORE(covered, inside);
        PACKET_STORE(w, disparity);
        for (int l = 0; l < PENCIL_WIDTH; ++l)
            if (inside[l] && disparity[l] >= row[x + l].disparity && disparity[l] <= nearest) {
                if (disparity[l] == row[x + l].disparity && triangle > row[x + l].triangle) continue;
                row[x + l].triangle = triangle;
                row[x + l].disparity = disparity[l];
            }
    }
}

/// Relative slack of a cluster's disparity: its triangles' disparities are rounded.
#define DISPARITY_SLACK 1e-5f

/// Slack of the bounding box of a triangle or cluster [texels], and the distance, in terms of a map's own directions, below which the box is not
/// trusted and its whole facet is searched instead.
#define BOX_SLACK 1e-2f
#define BOX_TRUSTED_DISTANCE 1e-2f

/// Texels whose centres lie in [low, high], both measured in texels from the first texel's lower border; widened by `slack` texels
/// because it only bounds the search: the edge functions decide.
static inline int2 raster_range(float low, float high, float slack, int last) {
    return (int2)(max((int)ceil(low - 0.5f - slack), 0), min((int)floor(high - 0.5f + slack), last));
}
