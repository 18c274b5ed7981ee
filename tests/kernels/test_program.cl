// Kernels that only test_program.cpp and test_device.cpp use.

#ifndef TEST_STEP
#define TEST_STEP 1
#endif

kernel void count_visits(global int *counts, int count) {
    int i = get_global_id(0);
    if (i < count) counts[i] += TEST_STEP;
}

kernel void count_visits_2d(global int *counts, int width, int height) {
    int x = get_global_id(0), y = get_global_id(1);
    if (x < width && y < height) counts[y * width + x] += 1;
}

kernel void report_width(global int *out) {
    if (get_global_id(0) == 0) out[0] = PENCIL_WIDTH;
}

kernel __attribute__((reqd_work_group_size(4, 1, 1))) void groups_of_four(global int *out) {
    if (get_local_id(0) == 0) out[get_group_id(0)] = get_local_size(0);
}

kernel void scale(global float *values, int count, float factor) {
    int i = get_global_id(0);
    if (i < count) values[i] *= factor;
}
