// Tells which surfels of a film need light of their own (lib/thin.cl).

#include "lib/thin.cl"

/// launch : 1-D, one work-item per pixel
/// in     : surfels of the film; counts, first_surfel of its pixels
/// out    : own[surfel]: 1 for those of every third pixel of every third row, and for those about which fewer than THIN_LEAST of these lie on
///          the same surface; 0 for all others
kernel void thin_film(global const float *surfels, int capacity, global const uchar *counts, global const int *first_surfel, int width,
                      int height, global uchar *own) {
    int item = get_global_id(0);
    if (item >= width * height) return;
    int2 pixel = (int2)(item % width, item / width);
    ThinFilm film = {counts, first_surfel, width, height};
    int found[4];
    float weights[4];
    for (int k = 0; k < (counts[item] & FILM_COUNT_MASK); ++k) {
        int i = first_surfel[item] + k;
        own[i] = is_thin_pixel(pixel) || thin_neighbours(&film, surfels, capacity, pixel, i, found, weights) < THIN_LEAST;
    }
}
