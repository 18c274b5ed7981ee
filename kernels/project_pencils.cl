// Projection R and scattering K: the radiance of a set of pencils, reflected by surfels (thesis eq. (5.23), alg. 6.3). The same kernel
// serves pencil transport (surfels of the next set's texels) and projection-scatter (surfels of the film): it is the hot loop.

/// Radiance (rgb) and density weight 1/D (w) by bilinear interpolation. DEVIATION: 1/D is interpolated, not D: it is what is used.
inline float4 fetch_radiance(global const float4 *radiance, int index, int stride, float fx, float fy) {
    global const float4 *t = radiance + index;
    float4 upper = t[0] + fx * (t[1] - t[0]);
    float4 lower = t[stride] + fx * (t[stride + 1] - t[stride]);
    return upper + fy * (lower - upper);
}

/// Sums over the pencils that a packet of surfels sees.
typedef struct ProjectionSums {
    float4 light[PENCIL_WIDTH];   // rgb: sum of L cos/D; w: sum of cos/D
    vint seen;                    // number of pencils
    float density[PENCIL_WIDTH];  // sum of D, for PENCIL_WEIGHTS_THESIS only
} ProjectionSums;

/// Adds pencil i to the sums of one packet.
inline void project_pencil(const SurfelPacket *s, const VisibilityMap *map, global const float4 *radiance, float4 cop, int i,
                           ProjectionSums *sums) {
    vfloat vx = s->x - cop.x, vy = s->y - cop.y, vz = s->z - cop.z;
    vfloat cosine = packet_cosine_towards(s, vx, vy, vz);
    vint faces = PACKET_MASK(cosine > 0.0f);
    if (!PACKET_ANY(faces)) return;
    Footprint f = packet_footprint(vx, vy, vz, map->n);
    vint index = f.index + i * PENCIL_TILE_TEXELS(map->n);
    vint seen = packet_visible(s, map, f, i, cop, faces);
    if (!PACKET_ANY(seen)) return;
    cosine *= rsqrt(fma(vx, vx, fma(vy, vy, vz * vz)));
    cosine = select((vfloat)(0.0f), cosine, seen);
    sums->seen -= seen;
    int stride = PENCIL_TILE_STRIDE(map->n);
#pragma unroll
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        float4 texel = fetch_radiance(radiance, LANE_INT(index, l), stride, LANE_FLOAT(f.fx, l), LANE_FLOAT(f.fy, l));
        float weight = LANE_FLOAT(cosine, l) * texel.w;
        sums->light[l] += weight * (float4)(texel.xyz, 1.0f);
        if (PENCIL_WEIGHTS_THESIS) sums->density[l] += LANE_INT(seen, l) ? 1.0f / texel.w : 0.0f;
    }
}

/// Irradiance from the sums of lane l.
inline float3 projected_irradiance(const ProjectionSums *sums, int l) {
    float4 light = sums->light[l];
    float seen = (float)LANE_INT(sums->seen, l);
    if (PENCIL_WEIGHTS_THESIS) return seen > 0.0f ? light.xyz * (2.0f * M_PI_F * sums->density[l] / (seen * seen)) : (float3)(0.0f);
    return light.w > 0.0f ? light.xyz * (M_PI_F / light.w) : (float3)(0.0f);
}

/// launch : 1-D, one work-item per block of PENCIL_BLOCK packets of PENCIL_WIDTH surfels
/// in     : surfels of `capacity` (a multiple of PENCIL_BLOCK * PENCIL_WIDTH); cops[pencil_count]; radiance, cells, groups, hits: tiles of
/// n x n
///          of those pencils
/// out    : outgoing[3][capacity] [W m^-2 sr^-1], added to if `accumulate`; visible[capacity]: number of pencils that each surfel sees
/// needs  : radiance and hits folded. A surfel that sees no pencil receives nothing.
/// PENCIL_WEIGHTS_THESIS 0: E = pi sum(L cos/D) / sum(cos/D). DEVIATION: eq. (5.33)'s normaliser does not tend to the integral.
/// PENCIL_WEIGHTS_THESIS 1: the printed form, E = 2 pi / n_v^2 * sum(D) * sum(L cos/D), n_v pencils visible.
kernel void project_pencils(global const float *surfels, int capacity, int surfel_count, global const float4 *cops, int pencil_count,
                            global const float4 *radiance, global const int2 *cells, global const int4 *groups, global const Hit *hits,
                            global const Triangle *triangles, global const float4 *planes, int n, global float *outgoing, int accumulate,
                            global int *visible) {
    int first = get_global_id(0) * PENCIL_BLOCK * PENCIL_WIDTH;
    if (first >= surfel_count) return;
    VisibilityMap map = {cells, groups, hits, triangles, planes, n};
    SurfelPacket packets[PENCIL_BLOCK];
    ProjectionSums sums[PENCIL_BLOCK];
    for (int p = 0; p < PENCIL_BLOCK; ++p) {
        packets[p] = load_surfels(surfels, capacity, first + p * PENCIL_WIDTH);
        sums[p].seen = 0;
        for (int l = 0; l < PENCIL_WIDTH; ++l) {
            sums[p].light[l] = (float4)(0.0f);
            sums[p].density[l] = 0.0f;
        }
    }
    for (int i = 0; i < pencil_count; ++i) {
        float4 cop = (float4)(cops[i].xyz, 0.0f);
        for (int p = 0; p < PENCIL_BLOCK; ++p) project_pencil(packets + p, &map, radiance, cop, i, sums + p);
    }
    for (int p = 0; p < PENCIL_BLOCK; ++p) {
        float r[PENCIL_WIDTH], g[PENCIL_WIDTH], b[PENCIL_WIDTH];
        for (int l = 0; l < PENCIL_WIDTH; ++l) {
            float3 e = projected_irradiance(sums + p, l);
            r[l] = e.x;
            g[l] = e.y;
            b[l] = e.z;
        }
        int at = first + p * PENCIL_WIDTH;
        scatter_irradiance(surfels, capacity, at, PACKET_LOAD(r), PACKET_LOAD(g), PACKET_LOAD(b), outgoing, accumulate);
        PACKET_STORE(sums[p].seen, visible + at);
    }
}
