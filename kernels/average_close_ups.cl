// What close-ups show becomes what the samples' own surfels show.

/// launch : 1-D, one work-item per sample of the pixels
/// in     : pixels[pixel_count], each sample of which has a surfel; first_surfel[pixel]; values[3][capacity]: of the surfels of close_ups
/// out    : of_film[3][film_capacity]: at the surfels of these samples the mean of their close-ups
kernel void average_close_ups(global const int *pixels, int pixel_count, int sample_count, int each, global const int *first_surfel,
                              global const float *values, int capacity, global float *of_film, int film_capacity) {
    int item = get_global_id(0);
    if (item >= pixel_count * sample_count) return;
    int surfel = first_surfel[pixels[item / sample_count]] + item % sample_count;
    for (int c = 0; c < 3; ++c) {
        global const float *v = values + (size_t)c * capacity + (size_t)item * each;
        float sum = 0.0f;
        for (int k = 0; k < each; ++k) sum += v[k];
        of_film[(size_t)c * film_capacity + surfel] = sum / each;
    }
}
