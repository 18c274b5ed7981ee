// A thin film: indirect light, which is smooth, is made for every third pixel of every third row, and for surfaces that these do not show.
// Other surfels receive the bilinear mean of the surfels about them on the same surface.

#include "lib/surfel.cl"
#include "shared/film.h"
#include "shared/surfel.h"

/// Surfels on one surface: in one plane, or with nearly the same normal and so little out of each other's plane, in terms of their distance.
#define THIN_NORMAL 0.97f
#define THIN_SLOPE 0.1f
/// Neighbours that light is taken from, at least.
#define THIN_LEAST 2

typedef struct ThinFilm {
    global const uchar *counts;
    global const int *first_surfel;
    int width, height;
} ThinFilm;

/// The first pixel of cell number `cell`, which is the thin one: of THIN_STEP x THIN_STEP pixels.
static inline int2 thin_pixel(int cell, int width) {
    int cells = (width + THIN_STEP - 1) / THIN_STEP;
    return THIN_STEP * (int2)(cell % cells, cell / cells);
}

static inline bool in_one_plane(global const float *surfels, size_t capacity, int i, int j) {
    return SURFEL_CONST_INT(surfels, SURFEL_PLANE * capacity + i) == SURFEL_CONST_INT(surfels, SURFEL_PLANE * capacity + j);
}

static inline bool on_one_side(global const float *surfels, size_t capacity, int i, int j) {
    return SURFEL_CONST_INT(surfels, SURFEL_MATERIAL * capacity + i) >> 31 ==
           SURFEL_CONST_INT(surfels, SURFEL_MATERIAL * capacity + j) >> 31;
}

static inline bool on_one_surface(global const float *surfels, size_t capacity, int i, int j) {
    if (in_one_plane(surfels, capacity, i, j)) return on_one_side(surfels, capacity, i, j);
    float3 n = surfel_vector(surfels, capacity, i, SURFEL_NX), m = surfel_vector(surfels, capacity, j, SURFEL_NX);
    float3 apart = surfel_vector(surfels, capacity, i, SURFEL_X) - surfel_vector(surfels, capacity, j, SURFEL_X);
    return dot(n, m) > THIN_NORMAL && fmax(fabs(dot(n, apart)), fabs(dot(m, apart))) < THIN_SLOPE * length(apart);
}

/// True if one of the surfels of a pixel lies on the surface of surfel i.
static inline bool pixel_shows_surface(const ThinFilm *film, global const float *surfels, size_t capacity, int2 pixel, int i) {
    int at = pixel.y * film->width + pixel.x, surfel = film->first_surfel[at], end = surfel + (film->counts[at] & FILM_COUNT_MASK);
    while (surfel < end && !on_one_surface(surfels, capacity, i, surfel)) ++surfel;
    return surfel < end;
}

/// True if the surface of surfel i goes on from its pixel to another: a wall that stands on it, wide as a pixel, ends it.
static inline bool surface_goes_on(const ThinFilm *film, global const float *surfels, size_t capacity, int2 from, int2 to, int i) {
    for (int k = 1; k < THIN_STEP; ++k) {
        int2 between = (int2)((from.x * (THIN_STEP - k) + to.x * k + THIN_STEP / 2) / THIN_STEP,
                              (from.y * (THIN_STEP - k) + to.y * k + THIN_STEP / 2) / THIN_STEP);
        if (!pixel_shows_surface(film, surfels, capacity, between, i)) return false;
    }
    return true;
}

/// Surfels of the thin pixels about `pixel` on the surface of surfel i, at most 4, with their bilinear weights; returns how many.
static inline int thin_neighbours(const ThinFilm *film, global const float *surfels, size_t capacity, int2 pixel, int i, int *found,
                                  float *weights) {
    int count = 0;
    int2 beyond = (int2)(pixel.x % THIN_STEP, pixel.y % THIN_STEP), corner = pixel - beyond;
    float2 share = convert_float2(beyond) / THIN_STEP;
    for (int k = 0; k < 4; ++k) {
        int2 at = corner + THIN_STEP * (int2)(k & 1, k >> 1);
        float weight = (k & 1 ? share.x : 1.0f - share.x) * (k >> 1 ? share.y : 1.0f - share.y);
        if (weight == 0.0f || at.x >= film->width || at.y >= film->height) continue;
        int other = at.y * film->width + at.x, surfel = film->first_surfel[other], end = surfel + (film->counts[other] & FILM_COUNT_MASK);
        while (surfel < end && !on_one_surface(surfels, capacity, i, surfel)) ++surfel;
        if (surfel == end || !surface_goes_on(film, surfels, capacity, pixel, at, i)) continue;
        found[count] = surfel;
        weights[count++] = weight;
    }
    return count;
}

/// True if the four thin pixels about a cell, and all between them, show one side of one plane and nothing else: all have all neighbours then.
static inline bool is_even_cell(const ThinFilm *film, global const float *surfels, size_t capacity, int2 corner) {
    if (corner.x + THIN_STEP >= film->width || corner.y + THIN_STEP >= film->height) return false;
    int first = corner.y * film->width + corner.x, i = film->first_surfel[first];
    for (int y = 0; y <= THIN_STEP; ++y)
        for (int x = 0; x <= THIN_STEP; ++x) {
            int at = first + y * film->width + x, j = film->first_surfel[at];
            if (film->counts[at] != 1 || !in_one_plane(surfels, capacity, i, j) || !on_one_side(surfels, capacity, i, j)) return false;
        }
    return true;
}
