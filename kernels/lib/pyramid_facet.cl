// The facets of a dual pyramid map: thesis eq. (4.14) with the parameters q, h of table 4.1, four for each hemisphere. DEVIATION: the table's
// v axis points down, this one as y.

#include "lib/raster.cl"

/// q of facet number 0 to 3 of a hemisphere.
static inline int2 pyramid_towards(int facet) { return facet & 2 ? (int2)(0, facet & 1 ? -1 : 1) : (int2)(facet & 1 ? -1 : 1, 0); }

/// Facets 0 to 3 are those of panel 0.
static inline FacetShape pyramid_facet(int facet) {
    FacetShape f;
    float2 q = convert_float2(pyramid_towards(facet));
    f.panel = facet / 4;
    float h = f.panel ? -1.0f : 1.0f;
    f.depth = (float4)(q, h, 0.0f);
    f.u = (float4)(1.0f, 0.0f, 0.0f, 0.0f);
    f.v = (float4)(0.0f, 1.0f, 0.0f, 0.0f);
    f.frame.origin = (float4)(0.0f, 0.0f, h, 0.0f);
    f.frame.du = (float4)(1.0f, 0.0f, -h * q.x, 0.0f);
    f.frame.dv = (float4)(0.0f, 1.0f, -h * q.y, 0.0f);
    f.sides[0] = (float4)(q.x - q.y, q.y + q.x, 0.0f, 0.0f);
    f.sides[1] = (float4)(q.x + q.y, q.y - q.x, 0.0f, 0.0f);
    f.sides[2] = f.sides[3] = (float4)(0.0f, 0.0f, h, 0.0f);
    return f;
}

/// First and last texel of row y of the panel that belong to the facet; first > last if none does. Centres with |u| = |v| are those of the
/// facets towards y: both projections agree there.
static inline int2 pyramid_facet_row(int facet, int y, int n) {
    int2 q = pyramid_towards(facet);
    int v = 2 * y + 1 - n, ring = abs(v);  // v n; n is even, so both are odd
    if (q.x == 0) return v * q.y > 0 ? (int2)(n - 1 - ring, n - 1 + ring) / 2 : (int2)(0, -1);
    int first = (n + 1 + ring) / 2;
    return q.x > 0 ? (int2)(first, n - 1) : (int2)(0, n - 1 - first);
}
