// Gives every surfel of a film the light of the picked ones (lib/thin.cl): its own, or the mean of its neighbours'.

#include "lib/thin.cl"

/// launch : 1-D, one work-item per pixel
/// in     : surfels of the film; counts, first_surfel of its pixels; place[surfel]: its number among the picked ones, -1: it is none of them;
///          picked[3][picked_capacity]: irradiance over pi [W m^-2 sr^-1]
/// out    : outgoing[3][capacity] [W m^-2 sr^-1], added to
kernel void spread_light(global const float *surfels, int capacity, global const uchar *counts, global const int *first_surfel, int width,
                         int height, global const int *place, global const float *picked, int picked_capacity, global float *outgoing) {
    int item = get_global_id(0);
    if (item >= width * height) return;
    int2 pixel = (int2)(item % width, item / width);
    ThinFilm film = {counts, first_surfel, width, height};
    for (int k = 0; k < (counts[item] & FILM_COUNT_MASK); ++k) {
        int i = first_surfel[item] + k, found[4] = {i}, count = 1;
        float weights[4] = {1.0f}, total = 0.0f;
        if (place[i] < 0) count = thin_neighbours(&film, surfels, capacity, pixel, i, found, weights);
        float3 sum = (float3)(0.0f);
        for (int j = 0; j < count; ++j) {
            sum += weights[j] * surfel_vector(picked, picked_capacity, place[found[j]], 0);
            total += weights[j];
        }
        sum *= surfel_vector(surfels, capacity, i, SURFEL_ALBEDO_R) / fmax(total, 1e-6f);
        outgoing[i] += sum.x;
        outgoing[(size_t)capacity + i] += sum.y;
        outgoing[2 * (size_t)capacity + i] += sum.z;
    }
}
