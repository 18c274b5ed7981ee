// Visibility of packets of surfels from one centre, by the rules of visibility.cl with as few branches as possible: most lanes are
// settled by their cell. Needs packet.cl, surfel_packet.cl, footprint.cl, visibility.cl.

/// Lanes whose cell is filled by plane `other` and that lie behind it as seen from `cop`; none if `other` is not a plane.
inline vint packet_behind(const SurfelPacket *s, global const float4 *planes, int other, float4 cop, vint fill)
{
    float4 plane = planes[max(other, 0)];
    vfloat ahead = plane.w - fma(s->x, (vfloat)(plane.x), fma(s->y, (vfloat)(plane.y), s->z * plane.z));
    float side = plane_ahead(plane, cop) > 0.0f ? 1.0f : -1.0f;
    return PACKET_MASK(fill == max(other, 0)) & PACKET_MASK(ahead * side <= -PLANE_TOLERANCE);
}

/// Lanes of `faces` that are seen from `cop`; `index` and (f.fx, f.fy) are their footprints in the atlas.
inline vint packet_visible(const SurfelPacket *s, const VisibilityMap *map, Footprint f, vint index, float4 cop, vint faces)
{
    // The cell shows the surfel's plane: seen. The same plane in both places: it fills the cell.
    int cells[2 * PENCIL_WIDTH];
#pragma unroll
    for (int l = 0; l < PENCIL_WIDTH; ++l) vstore2(map->cells[LANE_INT(index, l)], l, cells);
    vint first, second;
    PACKET_LOAD_PAIRS(cells, first, second);
    vint shown = PACKET_MASK(first == s->plane) | PACKET_MASK(second == s->plane);
    vint seen = faces & shown;
    vint open = faces & ~shown;
    if (!PACKET_ANY(open)) return seen;

    // One plane fills the cell: surfels behind it are hidden. Neighbouring lanes mostly look at the plane of the first or the last lane.
    vint fill = select((vint)(CELL_MIXED), first, PACKET_MASK(first == second));
    open &= ~packet_behind(s, map->planes, LANE_INT(fill, 0), cop, fill);
    if (!PACKET_ANY(open)) return seen;
    open &= ~packet_behind(s, map->planes, LANE_INT(fill, PENCIL_WIDTH - 1), cop, fill);
    if (!PACKET_ANY(open)) return seen;
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        if (!LANE_INT(open, l)) continue;
        if (LANE_INT(fill, l) != CELL_MIXED) {
            vint behind = packet_behind(s, map->planes, LANE_INT(fill, l), cop, fill);
            if (LANE_INT(behind, l)) continue;
        } else if (!mixed_footprint_visible(map, LANE_INT(index, l), LANE_FLOAT(f.fx, l), LANE_FLOAT(f.fy, l), cop, surfel_position(s, l),
                                            LANE_INT(s->plane, l))) {
            continue;
        }
        ((int *)&seen)[l] = -1;
    }
    return seen;
}
