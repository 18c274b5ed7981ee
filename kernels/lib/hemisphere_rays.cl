// Directions in which the texels of a surface pencil look: each through a point of its own.

#include "lib/hemisphere.cl"
#include "lib/packet.cl"
#include "lib/texel_points.cl"
#include "shared/surface_pencil.h"

/// Unit directions of the packet of map entries at `first`, of a map of n * n.
static inline void hemisphere_rays(global const SurfacePencil *pencil, int first, int n, uint seed, uint2 shift, vfloat *x, vfloat *y,
                                   vfloat *z) {
    float3 normal = pencil->normal.xyz, t, b;
    tangent_frame(normal, &t, &b);
    int column[PENCIL_WIDTH], row[PENCIL_WIDTH];
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        int2 texel = hemisphere_texel(first + l, n);
        column[l] = texel.x;
        row[l] = texel.y;
    }
    vfloat a, c, px, py;
    texel_points(pencil->key, first, column, row, n, seed, shift, &a, &c);
    concentric_disc(a, c, &px, &py);
    vfloat pz = sqrt(fmax(1.0f - px * px - py * py, (vfloat)(0.0f)));
    *x = px * t.x + py * b.x + pz * normal.x;
    *y = px * t.y + py * b.y + pz * normal.y;
    *z = px * t.z + py * b.z + pz * normal.z;
}
