// Visibility of packets of surfels from one centre, by the rules of visibility.cl with as few branches as possible: most lanes are
// settled by their cell. Needs packet.cl, surfel_packet.cl, footprint.cl, visibility.cl.

/// Lanes that lie behind plane `other` as seen from `cop`, of those for which `blocker` is that plane; none if `other` is not a plane.
inline vint packet_behind(const SurfelPacket *s, global const float4 *planes, int other, float4 cop, vint blocker) {
    float4 plane = planes[max(other, 0)];
    vfloat ahead = plane.w - fma(s->x, (vfloat)(plane.x), fma(s->y, (vfloat)(plane.y), s->z * plane.z));
    float side = plane_ahead(plane, cop) > 0.0f ? 1.0f : -1.0f;
    return PACKET_MASK(blocker == other) & PACKET_MASK(ahead * side <= -PLANE_TOLERANCE);
}

/// Settles the lanes of `open` one by one.
inline vint settle_lanes(const SurfelPacket *s, const VisibilityMap *map, Footprint f, int tile, float4 cop, vint first, vint blocker,
                         vint open) {
    int visible[PENCIL_WIDTH];
    int lanes = 0;
#pragma unroll
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        visible[l] = 0;
        lanes |= LANE_INT(open, l) & (1 << l);
    }
    while (lanes) {
        int l = 31 - clz(lanes);
        lanes &= ~(1 << l);
        int at = tile * PENCIL_TILE_TEXELS(map->n) + LANE_INT(f.index, l), own = LANE_INT(s->plane, l);
        float4 x = surfel_position(s, l);
        bool behind = true;
        if (LANE_INT(blocker, l) >= 0) {
            float4 plane = map->planes[LANE_INT(blocker, l)];
            behind = plane_ahead(plane, x) * (plane_ahead(plane, cop) > 0.0f ? 1.0f : -1.0f) <= -PLANE_TOLERANCE;
            if (behind && LANE_INT(blocker, l) == LANE_INT(first, l) && map->cells[at].y == LANE_INT(first, l)) continue;  // fills the cell
        }
        int2 corner = (int2)(LANE_INT(f.x, l), LANE_INT(f.y, l)) - PENCIL_GUTTER;
        visible[l] =
            !behind || mixed_footprint_visible(map, tile, corner, at, LANE_FLOAT(f.fx, l), LANE_FLOAT(f.fy, l), cop, x, own) ? -1 : 0;
    }
    return PACKET_LOAD(visible);
}

/// Lanes of `faces` that are seen from `cop`, the centre of `tile`; f are their footprints.
inline vint packet_visible(const SurfelPacket *s, const VisibilityMap *map, Footprint f, int tile, float4 cop, vint faces) {
    vint index = f.index + tile * PENCIL_TILE_TEXELS(map->n);
    int cells[2 * PENCIL_WIDTH];
#pragma unroll
    for (int l = 0; l < PENCIL_WIDTH; ++l) vstore2(map->cells[LANE_INT(index, l)], l, cells);
    vint first, second;
    PACKET_LOAD_PAIRS(cells, first, second);
    vint at_first = PACKET_MASK(first == s->plane);
    vint seen = faces & (at_first | PACKET_MASK(second == s->plane)) & PACKET_MASK(second >= -1);
    vint open = faces & ~seen;
    if (!PACKET_ANY(open)) return seen;

    // The one plane that can hide the surfel: that which fills the cell, or the other of a pair. Neighbouring lanes mostly have the blocker
    // of the first or the last lane.
    vint pair = CELL_PAIR(second);
    vint at_pair = PACKET_MASK(pair == s->plane);
    vint filled = PACKET_MASK(first == second) & PACKET_MASK(first >= 0);
    vint blocker = select((vint)(CELL_MIXED), first, filled | at_pair);
    blocker = select(blocker, pair, at_first & PACKET_MASK(second <= CELL_PAIR(0)));
    int first_blocker = LANE_INT(blocker, 0), last_blocker = LANE_INT(blocker, PENCIL_WIDTH - 1);
    vint behind = packet_behind(s, map->planes, first_blocker, cop, blocker) | packet_behind(s, map->planes, last_blocker, cop, blocker);
    vint settled = PACKET_MASK(blocker >= 0) & (PACKET_MASK(blocker == first_blocker) | PACKET_MASK(blocker == last_blocker));
    seen |= open & settled & ~behind;
    open &= ~settled | (behind & ~filled);  // behind the other of a pair: look at the triangles
    if (!PACKET_ANY(open)) return seen;
    return seen | settle_lanes(s, map, f, tile, cop, first, blocker, open);
}
