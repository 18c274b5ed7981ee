// How far a film pencil may be used: as what it sees is far away, and no further than emitters are from it or from its neighbours, which may see
// emitters that it does not (neighbour clamping, Krivanek et al. 2006). DEVIATION: other things that neighbours see clamp at a multiple of their distance:
// at once, many more pencils are needed about contacts, to no gain; not at all, light of the tops fills the pits of a relief.

#include "lib/film_lattice.cl"
#include "lib/surface_pencil.cl"
#include "shared/surface_pencil.h"

/// Neighbours to each side.
#define LIMIT_REACH 2
/// A pencil reaches no further than so many times what a neighbour sees is from it.
#define LIMIT_TIMES 4.0f

/// launch : 1-D, one work-item per pixel
/// in     : pencil_at[pixel], -1: none; spacing: of the neighbours [pixels]; first_new: pencils from this one on have no limit yet
/// in/out : pencils: facing.w
kernel void limit_reuse(global SurfacePencil *pencils, global const int *pencil_at, int spacing, int first_new, int width, int height) {
    int pixel = get_global_id(0);
    if (pixel >= width * height || pencil_at[pixel] < 0) return;
    global SurfacePencil *own = pencils + pencil_at[pixel];
    int2 at = (int2)(pixel % width, pixel / width);
    float least = pencil_at[pixel] < first_new ? own->facing.w : own->position.w;
    for (int dy = -LIMIT_REACH; dy <= LIMIT_REACH; ++dy)
        for (int dx = -LIMIT_REACH; dx <= LIMIT_REACH; ++dx) {
            int neighbour = lattice_neighbour(at, (int2)(dx, dy), spacing, width, height);
            int index = neighbour < 0 ? -1 : pencil_at[neighbour];
            if (index < 0) continue;
            float distance = reuse_distance(pencils + index, own->position.xyz, own->normal.xyz, INFINITY);
            if (distance < INFINITY) least = fmin(least, fmin(pencils[index].emitters, LIMIT_TIMES * pencils[index].position.w) + distance);
        }
    own->facing.w = least;
}
