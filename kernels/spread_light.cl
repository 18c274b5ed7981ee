// Gives every surfel of a film the light of the picked ones (lib/thin.cl): its own, or the mean of its neighbours'.

#include "lib/thin.cl"

/// Light of the picked surfels, irradiance over pi, and the place of each surfel of the film among them.
typedef struct PickedLight {
    global const float *light;
    size_t capacity;
    global const int *place;
} PickedLight;

static inline float3 picked_light(const PickedLight *picked, int surfel) {
    return surfel_vector(picked->light, picked->capacity, picked->place[surfel], 0);
}

/// Of surfel i of a pixel, by what lies about it.
static inline float3 light_about(const ThinFilm *film, global const float *surfels, size_t capacity, int2 pixel, int i,
                                 const PickedLight *picked) {
    if (picked->place[i] >= 0) return picked_light(picked, i);
    int found[4];
    float weights[4], total = 0.0f;
    int count = thin_neighbours(film, surfels, capacity, pixel, i, found, weights);
    float3 sum = (float3)(0.0f);
    for (int j = 0; j < count; ++j) {
        sum += weights[j] * picked_light(picked, found[j]);
        total += weights[j];
    }
    return sum / fmax(total, 1e-6f);
}

static inline void add_reflected(global const float *surfels, size_t capacity, int i, float3 light, global float *outgoing) {
    light *= surfel_vector(surfels, capacity, i, SURFEL_ALBEDO_R);
    outgoing[i] += light.x;
    outgoing[capacity + i] += light.y;
    outgoing[2 * capacity + i] += light.z;
}

/// All pixels of an even cell.
static inline void spread_evenly(const ThinFilm *film, global const float *surfels, size_t capacity, int2 corner, const PickedLight *picked,
                                 global float *outgoing) {
    float3 light[4];
    for (int k = 0; k < 4; ++k)
        light[k] =
            picked_light(picked, film->first_surfel[(corner.y + THIN_STEP * (k >> 1)) * film->width + corner.x + THIN_STEP * (k & 1)]);
    for (int y = 0; y < THIN_STEP; ++y) {
        float3 left = mix(light[0], light[2], (float)y / THIN_STEP), right = mix(light[1], light[3], (float)y / THIN_STEP);
        for (int x = 0; x < THIN_STEP; ++x)
            add_reflected(surfels, capacity, film->first_surfel[(corner.y + y) * film->width + corner.x + x],
                          mix(left, right, (float)x / THIN_STEP), outgoing);
    }
}

/// launch : 1-D, one work-item per cell (thin_pixel)
/// in     : surfels of the film; counts, first_surfel of its pixels; place[surfel]: its number among the picked ones, -1: it is none of them;
///          picked[3][picked_capacity]: irradiance over pi [W m^-2 sr^-1]
/// out    : outgoing[3][capacity] [W m^-2 sr^-1], added to
kernel void spread_light(global const float *surfels, int capacity, global const uchar *counts, global const int *first_surfel, int width,
                         int height, global const int *place, global const float *picked, int picked_capacity, global float *outgoing) {
    int2 corner = thin_pixel(get_global_id(0), width), end = min(corner + THIN_STEP, (int2)(width, height));
    if (corner.y >= height) return;
    ThinFilm film = {counts, first_surfel, width, height};
    PickedLight light = {picked, picked_capacity, place};
    if (is_even_cell(&film, surfels, capacity, corner)) {
        spread_evenly(&film, surfels, capacity, corner, &light, outgoing);
        return;
    }
    for (int y = corner.y; y < end.y; ++y)
        for (int x = corner.x; x < end.x; ++x) {
            int first = first_surfel[y * width + x], last = first + (counts[y * width + x] & FILM_COUNT_MASK);
            for (int i = first; i < last; ++i)
                add_reflected(surfels, capacity, i, light_about(&film, surfels, capacity, (int2)(x, y), i, &light), outgoing);
        }
}
