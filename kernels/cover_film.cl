// Film pencils: surface pencils on a lattice of pixels that is refined where their irradiance does not reach. A pixel at level `spacing`
// lies between four lattice points, whose coordinates are multiples of spacing or the film's last row or column.

#include "lib/film_lattice.cl"
#include "lib/surface_pencil.cl"
#include "shared/film.h"
#include "shared/surface_pencil.h"
#include "shared/surfel.h"

/// launch : 1-D, one work-item per pixel
/// in     : surfels of the film with their numbering; pencil_at[pixel]: film pencil of a pixel, -1: none; coarsest: largest spacing
/// out    : uncovered[capacity]: 1 if the least reuse_error of the lattice points about the surfel's
/// pixel exceeds `most_error`, else 0
kernel void cover_film(global const float *surfels, int capacity, global const uchar *counts, global const int *first_surfel,
                       global const SurfacePencil *pencils, global const int *pencil_at, int coarsest, int finest, float most_error,
                       int width, int height, global uchar *uncovered) {
    int pixel = get_global_id(0);
    if (pixel >= width * height) return;
    int2 at = (int2)(pixel % width, pixel / width);
    for (int i = first_surfel[pixel]; i < first_surfel[pixel] + (counts[pixel] & FILM_COUNT_MASK); ++i) {
        global const float *s = surfels + i;
        size_t c = capacity;
        if (PENCIL_LOBES && !(s[SURFEL_ALBEDO_R * c] + s[SURFEL_ALBEDO_G * c] + s[SURFEL_ALBEDO_B * c] > 0.0f)) {
            uncovered[i] = 0;  // mirrors, metal and glass reflect no irradiance
            continue;
        }
        SurfacePoint point = surface_point(surfels, capacity, i);
        float least = INFINITY;
        for (int spacing = coarsest; spacing >= finest && least > most_error; spacing /= 2)
            for (int corner = 0; corner < LATTICE_CORNERS; ++corner) {
                int pencil = lattice_pencil(pencil_at, at, spacing, coarsest, corner, width, height);
                if (pencil < 0) continue;
                float distance = reuse_distance(pencils + pencil, point.x, point.n, INFINITY);
                if (distance < INFINITY) least = fmin(least, reuse_error(pencils + pencil, distance, point.n));
            }
        uncovered[i] = least > most_error;
    }
}
