// Visibility of packets of surfels from one centre, by the rules of visibility.cl with as few branches as possible: most lanes are
// settled by their cell. Needs packet.cl, surfel_packet.cl, footprint.cl, visibility.cl.

/// Lanes that lie behind plane `other` as seen from `cop`, of those for which `blocker` is that plane; none if `other` is not a plane.
inline vint packet_behind(const SurfelPacket *s, global const float4 *planes, int other, float4 cop, vint blocker)
{
    float4 plane = planes[max(other, 0)];
    vfloat ahead = plane.w - fma(s->x, (vfloat)(plane.x), fma(s->y, (vfloat)(plane.y), s->z * plane.z));
    float side = plane_ahead(plane, cop) > 0.0f ? 1.0f : -1.0f;
    return PACKET_MASK(blocker == other) & PACKET_MASK(ahead * side <= -PLANE_TOLERANCE);
}

/// Lanes of `faces` that are seen from `cop`; `index` and (f.fx, f.fy) are their footprints in the atlas.
inline vint packet_visible(const SurfelPacket *s, const VisibilityMap *map, Footprint f, vint index, float4 cop, vint faces)
{
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
    vint behind = packet_behind(s, map->planes, LANE_INT(blocker, 0), cop, blocker);
    vint settled = PACKET_MASK(blocker == LANE_INT(blocker, 0));
    if (PACKET_ANY(open & ~settled)) {
        behind |= packet_behind(s, map->planes, LANE_INT(blocker, PENCIL_WIDTH - 1), cop, blocker);
        settled |= PACKET_MASK(blocker == LANE_INT(blocker, PENCIL_WIDTH - 1));
    }
    settled &= PACKET_MASK(blocker >= 0);
    seen |= open & settled & ~behind;
    open &= ~settled | (behind & ~filled);  // behind the other of a pair: look at the triangles
    if (!PACKET_ANY(open)) return seen;
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        if (!LANE_INT(open, l)) continue;
        int other = LANE_INT(blocker, l);
        if (other >= 0 && !LANE_INT(settled, l)) {
            vint hidden = packet_behind(s, map->planes, other, cop, blocker);
            if (!LANE_INT(hidden, l)) ((int *)&seen)[l] = -1;
            if (!LANE_INT(hidden, l) || LANE_INT(filled, l)) continue;
        }
        int at = LANE_INT(index, l), own = LANE_INT(s->plane, l);
        float fx = LANE_FLOAT(f.fx, l), fy = LANE_FLOAT(f.fy, l);
        float4 x = surfel_position(s, l);
        bool visible = LANE_INT(first, l) == CELL_MIXED ? mixed_cell_visible(map, at, fx, fy, cop, x, own)
                                                        : mixed_footprint_visible(map, at, fx, fy, cop, x, own);
        if (visible) ((int *)&seen)[l] = -1;
    }
    return seen;
}
