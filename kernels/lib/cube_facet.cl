// The six facets of a cube map are its panels.

#include "lib/cube.cl"
#include "lib/raster.cl"

static inline FacetShape cube_facet(int panel) {
    FacetShape f;
    int axis = panel / 2;
    f.panel = panel;
    f.depth = cube_turn(panel & 1 ? -1.0f : 1.0f, 0.0f, 0.0f, axis);
    f.u = cube_turn(0.0f, 1.0f, 0.0f, axis);
    f.v = cube_turn(0.0f, 0.0f, 1.0f, axis);
    f.frame.origin = f.depth;
    f.frame.du = f.u;
    f.frame.dv = f.v;
    f.sides[0] = f.depth - f.u;
    f.sides[1] = f.depth + f.u;
    f.sides[2] = f.depth - f.v;
    f.sides[3] = f.depth + f.v;
    return f;
}

/// First and last texel of row y of the panel that belong to the facet.
static inline int2 cube_facet_row(int facet, int y, int n) { return (int2)(0, n - 1); }
