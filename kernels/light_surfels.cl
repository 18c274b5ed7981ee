// Direct light of surfels from the light samples (thesis alg. 6.2), each with its own geometry map for visibility.

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH surfels
/// in     : surfels; samples[sample_count]; cops[sample_count]; plane_atlas, hits: tiles of n x n of the samples
/// out    : outgoing[3][capacity] [W m^-2 sr^-1], added to if `accumulate`
/// DEVIATION: cos cos / r^2 becomes cos cos / (r^2 + A/pi), A the area the sample stands for: the form factor of a disc of that area,
/// exact on its axis. It is bounded where r -> 0 and tends to the printed form as A does to 0. Point lights have A = 0 and cos_l = 1.
kernel void light_surfels(global const float *surfels, int capacity, int surfel_count, global const LightSample *samples, int sample_count,
                          global const float4 *cops, global const int *plane_atlas, global const Hit *hits,
                          global const Triangle *triangles, global const float4 *planes, int n, global float *outgoing, int accumulate)
{
    int first = get_global_id(0) * PENCIL_WIDTH;
    if (first >= surfel_count) return;
    SurfelPacket s = load_surfels(surfels, capacity, first);
    VisibilityMap map = {plane_atlas, hits, triangles, planes, n};
    vfloat r = 0.0f, g = 0.0f, b = 0.0f;
    for (int i = 0; i < sample_count; ++i) {
        float4 light = samples[i].position, normal = samples[i].normal, emission = samples[i].emission;
        float4 cop = (float4)(cops[i].xyz, 0.0f);
        vfloat vx = s.x - cop.x, vy = s.y - cop.y, vz = s.z - cop.z;
        vfloat weight = packet_cosine_towards(&s, vx, vy, vz);
        vfloat rr = fma(vx, vx, fma(vy, vy, vz * vz));
        vfloat inverse = rsqrt(rr);
        weight *= inverse;
        if (light.w != 0.0f) weight *= fmax(fma((vfloat)(normal.x), vx, fma((vfloat)(normal.y), vy, normal.z * vz)), (vfloat)(0.0f)) * inverse;
        weight /= rr + normal.w;
        if (!PACKET_ANY(PACKET_MASK(weight > 0.0f))) continue;
        Footprint f = packet_footprint(vx, vy, vz, n);
        vint base = f.index + i * PENCIL_TILE_TEXELS(n);
        float lane_weight[PENCIL_WIDTH], fx[PENCIL_WIDTH], fy[PENCIL_WIDTH];
        int index[PENCIL_WIDTH];
        PACKET_STORE(weight, lane_weight);
        PACKET_STORE(f.fx, fx);
        PACKET_STORE(f.fy, fy);
        PACKET_STORE(base, index);
#pragma unroll
        for (int l = 0; l < PENCIL_WIDTH; ++l) {
            float4 x = (float4)(s.px[l], s.py[l], s.pz[l], 0.0f);
            bool lit = lane_weight[l] > 0.0f && footprint_visible(&map, index[l], fx[l], fy[l], cop, x, s.plane[l]);
            if (!lit) lane_weight[l] = 0.0f;
        }
        weight = PACKET_LOAD(lane_weight);
        r = fma(weight, (vfloat)(emission.x), r);
        g = fma(weight, (vfloat)(emission.y), g);
        b = fma(weight, (vfloat)(emission.z), b);
    }
    scatter_irradiance(surfels, capacity, first, r, g, b, outgoing, accumulate);
}
