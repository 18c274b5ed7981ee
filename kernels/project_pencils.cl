// Projection R and scattering K: the radiance of a set of pencils, reflected by surfels (thesis eq. (5.23), alg. 6.3). The same kernel
// serves pencil transport (surfels of the next set's texels) and projection-scatter (surfels of the film): it is the hot loop.

/// Sums over the pencils that the surfels of a block see.
typedef struct ProjectionSums {
    float4 light[PENCIL_BLOCK * PENCIL_WIDTH];   // rgb: sum of L cos/D; w: sum of cos/D
    vint seen[PENCIL_BLOCK];                     // number of pencils
    float density[PENCIL_BLOCK * PENCIL_WIDTH];  // sum of D, for PENCIL_WEIGHTS_THESIS only
} ProjectionSums;

/// Aims one packet at pencil i and asks for the texels that it needs next.
inline void aim_at_pencil(const SurfelPacket *s, const VisibilityMap *map, global const float4 *radiance, float4 cop, int i, Aimed *aimed) {
    vfloat vx = s->x - cop.x, vy = s->y - cop.y, vz = s->z - cop.z;
    vfloat towards = packet_cosine_towards(s, vx, vy, vz);
    aimed->faces = PACKET_BITS(PACKET_MASK(towards > 0.0f));
    if (!aimed->faces) return;
    aim_packet(map, i, vx, vy, vz, aimed);
    aimed->weight = towards * packet_rsqrt(fma(vx, vx, fma(vy, vy, vz * vz)));
#pragma unroll
    for (int l = 0; l < PENCIL_WIDTH; l += 2) {
        global const float4 *texel = radiance + LANE_INT(aimed->f.index, l);
        PREFETCH(texel);
        PREFETCH(texel + PENCIL_TILE_STRIDE(map->n));
    }
}

/// Radiance (rgb) and density weight 1/D (w) by bilinear interpolation. DEVIATION: 1/D is interpolated, not D: it is what is used.
/// Two texels of a row are loaded at once.
inline float4 fetch_radiance(global const float4 *radiance, int index, int stride, float fx, float fy) {
    global const float *texel = (global const float *)(radiance + index);
    float8 upper = vload8(0, texel), lower = vload8(0, texel + 4 * stride);
    float8 row = upper + fy * (lower - upper);
    return row.lo + fx * (row.hi - row.lo);
}

/// Adds what surfel number `surfel` of the block receives along its aimed direction to the sums.
inline void add_seen(const Aimed *block, uint surfel, global const float4 *radiance, int stride, ProjectionSums *sums) {
    const Aimed *aimed = block + surfel / PENCIL_WIDTH;
    uint l = surfel % PENCIL_WIDTH;
    float4 texel = fetch_radiance(radiance, LANE_INT(aimed->f.index, l), stride, LANE_FLOAT(aimed->f.fx, l), LANE_FLOAT(aimed->f.fy, l));
    float weight = LANE_FLOAT(aimed->weight, l) * texel.w;
    sums->light[surfel] += weight * (float4)(texel.xyz, 1.0f);
    if (PENCIL_WEIGHTS_THESIS) sums->density[surfel] += 1.0f / texel.w;
}

/// Adds pencil i to the sums of a block: aims all packets, then lists what they see, then fetches what is on the list in one loop without
/// branches.
inline void project_pencil(const SurfelPacket *packets, const VisibilityMap *map, global const float4 *radiance, float4 cop, int i,
                           ProjectionSums *sums) {
    Aimed aimed[PENCIL_BLOCK];
    for (int p = 0; p < PENCIL_BLOCK; ++p) aim_at_pencil(packets + p, map, radiance, cop, i, aimed + p);
    int seen[(PENCIL_BLOCK + 1) * PENCIL_WIDTH], count = 0;
    for (int p = 0; p < PENCIL_BLOCK; ++p) {
        int lanes = packet_visible(packets + p, map, aimed + p, i, cop);
        packet_store_packed(p * PENCIL_WIDTH + PACKET_LANES, lanes, seen + count);
        count += popcount(lanes);
        sums->seen[p] -= PACKET_FROM_BITS(lanes);
    }
    const int stride = PENCIL_TILE_STRIDE(map->n);
    // The remainder changes nothing, but is a constant where a block is one surfel, and private arrays can then be registers.
    for (int k = 0; k < count; ++k) add_seen(aimed, (uint)seen[k] % (PENCIL_BLOCK * PENCIL_WIDTH), radiance, stride, sums);
}

/// Irradiance from the sums of surfel l of the block.
inline float3 projected_irradiance(const ProjectionSums *sums, int l) {
    float4 light = sums->light[l];
    float seen = (float)LANE_INT(sums->seen, l);
    if (PENCIL_WEIGHTS_THESIS) return seen > 0.0f ? light.xyz * (2.0f * M_PI_F * sums->density[l] / (seen * seen)) : (float3)(0.0f);
    return light.w > 0.0f ? light.xyz * (M_PI_F / light.w) : (float3)(0.0f);
}

/// launch : 1-D, one work-item per block of PENCIL_BLOCK packets of PENCIL_WIDTH surfels
/// in     : surfels of `capacity` (a multiple of PENCIL_BLOCK * PENCIL_WIDTH); cops[pencil_count]; radiance, cells, groups, hits:
///          tiles of n x n of those pencils
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
    for (int p = 0; p < PENCIL_BLOCK; ++p) packets[p] = load_surfels(surfels, capacity, first + p * PENCIL_WIDTH);
    ProjectionSums sums;
    for (int l = 0; l < PENCIL_BLOCK * PENCIL_WIDTH; ++l) {
        sums.light[l] = (float4)(0.0f);
        sums.density[l] = 0.0f;
    }
    for (int p = 0; p < PENCIL_BLOCK; ++p) sums.seen[p] = 0;
    for (int i = 0; i < pencil_count; ++i) project_pencil(packets, &map, radiance, (float4)(cops[i].xyz, 0.0f), i, &sums);
    for (int p = 0; p < PENCIL_BLOCK; ++p) {
        float r[PENCIL_WIDTH], g[PENCIL_WIDTH], b[PENCIL_WIDTH];
        for (int l = 0; l < PENCIL_WIDTH; ++l) {
            float3 e = projected_irradiance(&sums, p * PENCIL_WIDTH + l);
            r[l] = e.x;
            g[l] = e.y;
            b[l] = e.z;
        }
        scatter_irradiance(surfels, capacity, first + p * PENCIL_WIDTH, PACKET_LOAD(r), PACKET_LOAD(g), PACKET_LOAD(b), outgoing,
                           accumulate);
        PACKET_STORE(sums.seen[p], visible + first + p * PENCIL_WIDTH);
    }
}
