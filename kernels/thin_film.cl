// Tells which surfels of a film need light of their own (lib/thin.cl).

#include "lib/thin.cl"

/// Number of neighbours that a surfel of a pixel of an uneven cell has.
static inline int neighbour_count(const ThinFilm *film, global const float *surfels, size_t capacity, int2 pixel, int i) {
    int found[4];
    float weights[4];
    return thin_neighbours(film, surfels, capacity, pixel, i, found, weights);
}

/// launch : 1-D, one work-item per cell (thin_pixel)
/// in     : surfels of the film; counts, first_surfel of its pixels
/// out    : own[surfel]: 1 for those of every third pixel of every third row, and for those about which fewer than THIN_LEAST of these lie on
///          the same surface; 0 for all others
kernel void thin_film(global const float *surfels, int capacity, global const uchar *counts, global const int *first_surfel, int width,
                      int height, global uchar *own) {
    int2 corner = thin_pixel(get_global_id(0), width), end = min(corner + THIN_STEP, (int2)(width, height));
    if (corner.y >= height) return;
    ThinFilm film = {counts, first_surfel, width, height};
    bool even = is_even_cell(&film, surfels, capacity, corner);
    for (int y = corner.y; y < end.y; ++y)
        for (int x = corner.x; x < end.x; ++x) {
            int first = first_surfel[y * width + x], last = first + (counts[y * width + x] & FILM_COUNT_MASK);
            bool thin = x == corner.x && y == corner.y;
            for (int i = first; i < last; ++i)
                own[i] = thin || (!even && neighbour_count(&film, surfels, capacity, (int2)(x, y), i) < THIN_LEAST);
        }
}
