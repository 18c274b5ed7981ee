// Which pencils each surfel sees, one bit each: V(x, c_i) of thesis eq. (5.17) for a whole set.

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH surfels
/// in     : surfels; cops[pencil_count]; plane_atlas, hits: tiles of n x n of those pencils, folded
/// out    : mask[word][capacity]: bit i % 32 of word i / 32 is set if pencil i sees the surfel from the side that is shaded
kernel void test_visibility(global const float *surfels, int capacity, int surfel_count, global const float4 *cops, int pencil_count,
                            global const int *plane_atlas, global const Hit *hits, global const Triangle *triangles,
                            global const float4 *planes, int n, global uint *mask)
{
    int first = get_global_id(0) * PENCIL_WIDTH;
    if (first >= surfel_count) return;
    SurfelPacket s = load_surfels(surfels, capacity, first);
    VisibilityMap map = {plane_atlas, hits, triangles, planes, n};
    for (int word = 0; word * 32 < pencil_count; ++word) {
        uint bits[PENCIL_WIDTH];
        for (int l = 0; l < PENCIL_WIDTH; ++l) bits[l] = 0;
        for (int i = 32 * word; i < min(32 * word + 32, pencil_count); ++i) {
            float4 cop = (float4)(cops[i].xyz, 0.0f);
            vfloat vx = s.x - cop.x, vy = s.y - cop.y, vz = s.z - cop.z;
            vfloat cosine = packet_cosine_towards(&s, vx, vy, vz);
            if (!PACKET_ANY(PACKET_MASK(cosine > 0.0f))) continue;
            Footprint f = packet_footprint(vx, vy, vz, n);
            vint base = f.index + i * PENCIL_TILE_TEXELS(n);
            float lane_cosine[PENCIL_WIDTH], fx[PENCIL_WIDTH], fy[PENCIL_WIDTH];
            int index[PENCIL_WIDTH];
            PACKET_STORE(cosine, lane_cosine);
            PACKET_STORE(f.fx, fx);
            PACKET_STORE(f.fy, fy);
            PACKET_STORE(base, index);
            for (int l = 0; l < PENCIL_WIDTH; ++l) {
                if (!(lane_cosine[l] > 0.0f)) continue;
                float4 x = (float4)(s.px[l], s.py[l], s.pz[l], 0.0f);
                if (footprint_visible(&map, index[l], fx[l], fy[l], cop, x, s.plane[l])) bits[l] |= 1u << (i % 32);
            }
        }
        PACKET_STORE(PACKET_LOAD(bits), mask + (size_t)word * capacity + first);
    }
}
