// Surfel values to pixels by the reconstruction filter, over all visibility samples of all pixels in its support.
// A surfel stands for all its samples in its pixel, which blurs what changes within it. Where it lies at a drawn one, what its value differs by
// from what the same material shows in the pixels about counts by the weight of that sample times the number of samples instead: the mean of
// images is the filtered image, and an even surface has no noise of it.

#include "shared/film.h"
#include "shared/surfel.h"

/// Materials about a pixel that are told apart; surfels of others differ from 0.
#define FILM_KINDS 4

typedef struct FilmValues {
    global const float *values;  // first of three fields
    size_t capacity;
    global const uchar *slots, *counts;
    global const int *first_surfel;
    int sample_count;
    global const float *background;
    int has_background;
} FilmValues;

/// Pixels about one, itself among them, of rows low.y to high.y and columns low.x to high.x.
typedef struct FilmWindow {
    int2 centre, low, high;
    int width, reach;
} FilmWindow;

/// Number of a pixel's place among those about the centre, in tables of the filter.
static inline int window_cell(const FilmWindow *w, int x, int y) {
    return (y - w->centre.y + w->reach) * (2 * w->reach + 1) + x - w->centre.x + w->reach;
}

static inline float3 film_value(const FilmValues *f, int surfel) {
    global const float *v = f->values + surfel;
    return (float3)(v[0], v[f->capacity], v[2 * f->capacity]);
}

/// What the samples of a pixel show, times their weights; `total`: of all of them.
static inline float3 cell_sum(const FilmValues *f, int pixel, global const float *weights, float total) {
    if (f->counts[pixel] == 1) return total * film_value(f, f->first_surfel[pixel]);  // one surface, no empty sample
    global const uchar *slot = f->slots + (size_t)pixel * f->sample_count;
    float3 sum = (float3)(0.0f);
    for (int s = 0; s < f->sample_count; ++s)
        if (slot[s] != NO_SURFEL)
            sum += weights[s] * film_value(f, f->first_surfel[pixel] + slot[s]);
        else if (f->has_background)
            sum += weights[s] * vload3(pixel, f->background);
    return sum;
}

/// What the materials about a pixel show, each in the sum over its surfels.
typedef struct FilmKinds {
    int rows[FILM_KINDS], counts[FILM_KINDS];
    float3 sums[FILM_KINDS];
    int used;
} FilmKinds;

static inline int film_row(global const float *surfels, size_t capacity, int surfel) {
    return SURFEL_CONST_INT(surfels, SURFEL_MATERIAL * capacity + surfel);
}

static inline int find_kind(const FilmKinds *kinds, int row) {
    int kind = 0;
    while (kind < kinds->used && kinds->rows[kind] != row) ++kind;
    return kind;
}

static inline void add_kinds(const FilmValues *f, int pixel, global const float *surfels, FilmKinds *kinds) {
    int first = f->first_surfel[pixel], end = first + (f->counts[pixel] & FILM_COUNT_MASK);
    for (int surfel = first; surfel < end; ++surfel) {
        int row = film_row(surfels, f->capacity, surfel), kind = find_kind(kinds, row);
        if (kind == FILM_KINDS) continue;
        if (kind == kinds->used) {
            kinds->rows[kind] = row;
            kinds->counts[kind] = 0;
            kinds->sums[kind] = (float3)(0.0f);
            ++kinds->used;
        }
        kinds->sums[kind] += film_value(f, surfel);
        ++kinds->counts[kind];
    }
}

/// What a surfel of a pixel differs by from what its material shows in the other pixels about, so that none of its own chance is in that.
static inline float3 film_difference(const FilmValues *f, int pixel, int surfel, global const float *surfels, const FilmKinds *kinds) {
    float3 value = film_value(f, surfel);
    int row = film_row(surfels, f->capacity, surfel), kind = find_kind(kinds, row);
    if (kind == kinds->used) return value;
    float3 sum = kinds->sums[kind];
    int count = kinds->counts[kind], first = f->first_surfel[pixel], end = first + (f->counts[pixel] & FILM_COUNT_MASK);
    for (int own = first; own < end; ++own)
        if (film_row(surfels, f->capacity, own) == row) {
            sum -= film_value(f, own);
            --count;
        }
    return count > 0 ? value - sum / count : value;
}

/// What is to be added for a pixel, since its surfels lie at drawn samples.
static inline float3 cell_step(const FilmValues *f, int pixel, global const float *weights, global const uchar *drawn,
                               global const float *surfels, const FilmKinds *kinds) {
    global const uchar *slot = f->slots + (size_t)pixel * f->sample_count;
    int first = f->first_surfel[pixel];
    float3 step = (float3)(0.0f);
    if ((f->counts[pixel] & FILM_COUNT_MASK) == f->sample_count) return step;  // each stands for itself
    for (int k = 0; k < (f->counts[pixel] & FILM_COUNT_MASK); ++k) {
        float all = 0.0f;
        int members = 0;
        for (int s = 0; s < f->sample_count; ++s)
            if (slot[s] == k) {
                all += weights[s];
                ++members;
            }
        step += (members * weights[drawn[first + k]] - all) * film_difference(f, pixel, first + k, surfels, kinds);
    }
    return step;
}

/// Sum of light times the filter over the pixels of a window that show one thing alone; w: their number. norm: the filter's sum over all.
static inline float4 whole_sum(const FilmWindow *window, global const float *totals, global const float4 *whole, float *norm) {
    float4 sum = (float4)(0.0f);
    *norm = 0.0f;
    for (int y = window->low.y; y <= window->high.y; ++y)
        for (int x = window->low.x; x <= window->high.x; ++x) {
            float total = totals[window_cell(window, x, y)];
            *norm += total;
            sum += (float4)(total, total, total, 1.0f) * whole[y * window->width + x];
        }
    return sum;
}

/// The same over all pixels of a window, sample by sample where they show more.
static inline float3 window_sum(const FilmValues *f, const FilmWindow *window, global const float *weights, global const float *totals) {
    float3 sum = (float3)(0.0f);
    for (int y = window->low.y; y <= window->high.y; ++y)
        for (int x = window->low.x; x <= window->high.x; ++x) {
            int cell = window_cell(window, x, y);
            sum += cell_sum(f, y * window->width + x, weights + cell * f->sample_count, totals[cell]);
        }
    return sum;
}

/// What is to be added to it, since surfels lie at drawn samples.
static inline float3 window_steps(const FilmValues *f, const FilmWindow *window, global const float *weights, global const uchar *drawn,
                                  global const float *surfels) {
    FilmKinds kinds;
    kinds.used = 0;
    for (int y = window->low.y; y <= window->high.y; ++y)
        for (int x = window->low.x; x <= window->high.x; ++x) add_kinds(f, y * window->width + x, surfels, &kinds);
    float3 steps = (float3)(0.0f);
    for (int y = window->low.y; y <= window->high.y; ++y)
        for (int x = window->low.x; x <= window->high.x; ++x) {
            int cell = window_cell(window, x, y);
            steps += cell_step(f, y * window->width + x, weights + cell * f->sample_count, drawn, surfels, &kinds);
        }
    return steps;
}

/// launch : 1-D, one work-item per pixel
/// in     : values, fields first_field .. first_field + 2 of [field][capacity]; whole[pixel], of whole_pixels; slots, counts, first_surfel;
///          weights[(2 reach + 1)^2 * sample_count]: the filter at each sample of each neighbour, row by row; totals[(2 reach + 1)^2]: sums
///          over the samples of a neighbour; background[pixel * 3 + channel], if has_background: what samples show that show no surface; if
///          at_drawn, surfels, as many, and drawn[surfel]: the sample that it lies at
/// out    : image[pixel * 3 + channel]
kernel void resolve_film(global const float *values, int first_field, int capacity, global const float4 *whole, global const uchar *slots,
                         global const uchar *counts, global const int *first_surfel, global const float *weights,
                         global const float *totals, int reach, int sample_count, int width, int height, global const float *background,
                         int has_background, global const float *surfels, global const uchar *drawn, int at_drawn, global float *image) {
    int pixel = get_global_id(0);
    if (pixel >= width * height) return;
    FilmValues film = {
        values + (size_t)first_field * capacity, capacity, slots, counts, first_surfel, sample_count, background, has_background};
    int2 centre = (int2)(pixel % width, pixel / width), low = max(centre - reach, 0), high = min(centre + reach, (int2)(width, height) - 1);
    FilmWindow window = {centre, low, high, width, reach};
    float norm;
    float4 alone = whole_sum(&window, totals, whole, &norm);
    bool is_whole = alone.w == (float)((high.x - low.x + 1) * (high.y - low.y + 1));
    float3 sum = is_whole ? alone.xyz : window_sum(&film, &window, weights, totals), steps = (float3)(0.0f);
    if (at_drawn) steps = window_steps(&film, &window, weights, drawn, surfels);
    vstore3(norm > 0.0f ? (sum + steps) / norm : (float3)(0.0f), pixel, image);
}
