// Local projection to the film: every surfel takes its irradiance from the film pencils at the lattice points about its pixel.

/// launch : 1-D, one work-item per pixel
/// in     : as cover_film; most_error: reuse_error at which a pencil's weight falls to 0
/// out    : outgoing[3][capacity] [W m^-2 sr^-1] of the pixel's surfels, added to
kernel void project_film_pencils(global const float *surfels, int capacity, global const uchar *counts, global const int *first_surfel,
                                 global const SurfacePencil *pencils, global const float4 *irradiance, global const int *pencil_at,
                                 int coarsest, int finest, float most_error, int width, int height, global float *outgoing) {
    int pixel = get_global_id(0);
    if (pixel >= width * height) return;
    int2 at = (int2)(pixel % width, pixel / width);
    for (int k = 0; k < (counts[pixel] & FILM_COUNT_MASK); ++k) {
        int i = first_surfel[pixel] + k;
        SurfacePoint point = surface_point(surfels, capacity, i);
        float4 sum = (float4)(0.0f), last = (float4)(0.0f);
        float least = INFINITY;
        for (int spacing = coarsest; spacing >= finest; spacing /= 2)
            for (int corner = 0; corner < 4; ++corner) {
                int index = lattice_pencil(pencil_at, at, spacing, coarsest, corner, width, height);
                if (index < 0) continue;
                global const SurfacePencil *pencil = pencils + index;
                float distance = reuse_distance(pencil, point.x, point.n, INFINITY);
                float error = distance < INFINITY ? fmax(reuse_error(pencil, distance, point.n), 0.02f * most_error) : INFINITY;
                int2 apart = convert_int2(abs_diff(lattice_pixel(at, spacing, corner, width, height), at));
                float tent = fmax(1.0f - apart.x / (float)spacing, 0.0f) * fmax(1.0f - apart.y / (float)spacing, 0.0f);
                float weight = fmax(1.0f / error - 1.0f / most_error, 0.0f) * tent;
                sum += weight * (float4)(irradiance[index].xyz, 1.0f);
                // No pencil reaches: take the most similar one.
                float3 step = pencil->position.xyz - point.x;
                float unlike = dot(step, step) + (1.0f - dot(pencil->normal.xyz, point.n)) * 0.25f;
                if (unlike < least) {
                    least = unlike;
                    last = (float4)(irradiance[index].xyz, 1.0f);
                }
            }
        if (sum.w <= 0.0f) sum = last;
        if (sum.w <= 0.0f) continue;
        float3 e = sum.xyz / sum.w * M_1_PI_F;
        size_t c = capacity;
        outgoing[i] += e.x * surfels[SURFEL_ALBEDO_R * c + i];
        outgoing[c + i] += e.y * surfels[SURFEL_ALBEDO_G * c + i];
        outgoing[2 * c + i] += e.z * surfels[SURFEL_ALBEDO_B * c + i];
    }
}
