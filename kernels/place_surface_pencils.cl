// Puts surface pencils on surfels.

/// launch : 1-D, one work-item per new pencil
/// in     : surfels; chosen[count]: the surfel of each pencil; radius [scene units]
/// out    : pencils[first ..]: position, normal, facing; the rest is 0 until they are traced and summed
kernel void place_surface_pencils(global const float *surfels, int capacity, global const int *chosen, int count, float radius,
                                  float spacing, int first, global SurfacePencil *pencils) {
    int item = get_global_id(0);
    if (item >= count) return;
    global const float *s = surfels + chosen[item];
    global SurfacePencil *pencil = pencils + first + item;
    size_t c = capacity;
    pencil->position = (float4)(s[SURFEL_X * c], s[SURFEL_Y * c], s[SURFEL_Z * c], 0.0f);
    pencil->normal = (float4)(s[SURFEL_NX * c], s[SURFEL_NY * c], s[SURFEL_NZ * c], radius);
    pencil->facing = (float4)(s[SURFEL_GX * c], s[SURFEL_GY * c], s[SURFEL_GZ * c], spacing);
    pencil->irradiance = (float4)(0.0f);
    for (int k = 0; k < RING_SECTORS; ++k) pencil->ring[k] = 0.0f;
}
