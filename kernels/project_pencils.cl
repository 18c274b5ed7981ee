// Projection R and scattering K: the radiance of a set of pencils, reflected by surfels (thesis eq. (5.23), alg. 6.3). The same kernel
// serves pencil transport (surfels of the next set's texels) and projection-scatter (surfels of the film): it is the hot loop.

/// Radiance (rgb) and density weight 1/D (w) by bilinear interpolation. DEVIATION: 1/D is interpolated, not D: it is what is used.
inline float4 fetch_radiance(global const float4 *radiance, int index, int stride, float fx, float fy)
{
    global const float4 *t = radiance + index;
    float4 upper = t[0] + fx * (t[1] - t[0]);
    float4 lower = t[stride] + fx * (t[stride + 1] - t[stride]);
    return upper + fy * (lower - upper);
}

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH surfels
/// in     : surfels of `capacity` (a multiple of 16); cops[pencil_count]; radiance, plane_atlas, hits: tiles of n x n of those pencils
/// out    : outgoing[3][capacity] [W m^-2 sr^-1], added to if `accumulate`; visible[capacity]: number of pencils that each surfel sees
/// needs  : radiance and hits folded. A surfel that sees no pencil receives nothing.
/// PENCIL_WEIGHTS_THESIS 0: E = pi sum(L cos/D) / sum(cos/D). DEVIATION: eq. (5.33)'s normaliser does not tend to the integral.
/// PENCIL_WEIGHTS_THESIS 1: the printed form, E = 2 pi / n_v^2 * sum(D) * sum(L cos/D), n_v pencils visible.
kernel void project_pencils(global const float *surfels, int capacity, int surfel_count, global const float4 *cops, int pencil_count,
                            global const float4 *radiance, global const int *plane_atlas, global const Hit *hits,
                            global const Triangle *triangles, global const float4 *planes, int n, global float *outgoing, int accumulate,
                            global int *visible)
{
    int first = get_global_id(0) * PENCIL_WIDTH;
    if (first >= surfel_count) return;
    SurfelPacket s = load_surfels(surfels, capacity, first);
    VisibilityMap map = {plane_atlas, hits, triangles, planes, n};
    int stride = PENCIL_TILE_STRIDE(n);
    float4 sum[PENCIL_WIDTH];  // rgb: sum of L cos/D; w: sum of cos/D
    float sum_density[PENCIL_WIDTH];
    int seen[PENCIL_WIDTH];
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        sum[l] = (float4)(0.0f);
        sum_density[l] = 0.0f;
        seen[l] = 0;
    }
    for (int i = 0; i < pencil_count; ++i) {
        float4 cop = (float4)(cops[i].xyz, 0.0f);
        vfloat vx = s.x - cop.x, vy = s.y - cop.y, vz = s.z - cop.z;
        vfloat cosine = packet_cosine_towards(&s, vx, vy, vz);
        if (!PACKET_ANY(PACKET_MASK(cosine > 0.0f))) continue;
        cosine *= rsqrt(fma(vx, vx, fma(vy, vy, vz * vz)));
        Footprint f = packet_footprint(vx, vy, vz, n);
        vint base = f.index + i * PENCIL_TILE_TEXELS(n);
        float lane_cosine[PENCIL_WIDTH], fx[PENCIL_WIDTH], fy[PENCIL_WIDTH];
        int index[PENCIL_WIDTH];
        PACKET_STORE(cosine, lane_cosine);
        PACKET_STORE(f.fx, fx);
        PACKET_STORE(f.fy, fy);
        PACKET_STORE(base, index);
#pragma unroll
        for (int l = 0; l < PENCIL_WIDTH; ++l) {
            if (!(lane_cosine[l] > 0.0f)) continue;
            float4 x = (float4)(s.px[l], s.py[l], s.pz[l], 0.0f);
            if (!footprint_visible(&map, index[l], fx[l], fy[l], cop, x, s.plane[l])) continue;
            float4 texel = fetch_radiance(radiance, index[l], stride, fx[l], fy[l]);
            sum[l] += (lane_cosine[l] * texel.w) * (float4)(texel.xyz, 1.0f);
            ++seen[l];
            if (PENCIL_WEIGHTS_THESIS) sum_density[l] += 1.0f / texel.w;
        }
    }
    float r[PENCIL_WIDTH], g[PENCIL_WIDTH], b[PENCIL_WIDTH];
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        float scale = sum[l].w > 0.0f ? M_PI_F / sum[l].w : 0.0f;
        if (PENCIL_WEIGHTS_THESIS) scale = seen[l] > 0 ? 2.0f * M_PI_F * sum_density[l] / ((float)seen[l] * seen[l]) : 0.0f;
        r[l] = scale * sum[l].x;
        g[l] = scale * sum[l].y;
        b[l] = scale * sum[l].z;
    }
    scatter_irradiance(surfels, capacity, first, PACKET_LOAD(r), PACKET_LOAD(g), PACKET_LOAD(b), outgoing, accumulate);
    PACKET_STORE(PACKET_LOAD(seen), visible + first);
}
