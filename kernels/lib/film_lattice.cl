// The lattice of pixels that film pencils lie on.

#include "shared/surfel.h"

typedef struct SurfacePoint {
    float3 x, n;
} SurfacePoint;

static inline SurfacePoint surface_point(global const float *surfels, int capacity, int i) {
    size_t c = capacity;
    global const float *s = surfels + i;
    SurfacePoint p = {(float3)(s[SURFEL_X * c], s[SURFEL_Y * c], s[SURFEL_Z * c]),
                      (float3)(s[SURFEL_NX * c], s[SURFEL_NY * c], s[SURFEL_NZ * c])};
    return p;
}

/// Corners of the square of lattice points about a pixel.
#define LATTICE_CORNERS 4

/// Pixel of a lattice corner, 0 .. LATTICE_CORNERS - 1, about pixel `at`.
static inline int2 lattice_pixel(int2 at, int spacing, int corner, int width, int height) {
    int2 p = at / spacing * spacing + spacing * (int2)(corner & 1, corner >> 1);
    return min(p, (int2)(width - 1, height - 1));
}

/// Film pencil of that corner, -1 if there is none or a coarser level has it.
static inline int lattice_pencil(global const int *pencil_at, int2 at, int spacing, int coarsest, int corner, int width, int height) {
    int2 p = lattice_pixel(at, spacing, corner, width, height);
    if (spacing < coarsest && ((p.x | p.y) & (2 * spacing - 1)) == 0) return -1;
    return pencil_at[p.y * width + p.x];
}

/// Pixel of the lattice point that is `steps` points away from that of pixel `at`; -1: there is none.
static inline int lattice_neighbour(int2 at, int2 steps, int spacing, int width, int height) {
    int2 last = (int2)(width - 1, height - 1), place = (at + (spacing - 1)) / spacing + steps;
    if (any(place < 0) || any(place > (last + (spacing - 1)) / spacing)) return -1;
    int2 p = min(place * spacing, last);
    return p.y * width + p.x;
}
