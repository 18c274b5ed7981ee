// Visibility of packets of surfels from one centre, by the rules of visibility.cl. Cells settle most lanes; what they leave open is settled
// for all lanes at once that share a blocker, then for all lanes at once that share the triangles about their footprints: neighbouring
// lanes mostly do. Needs packet.cl, surfel_packet.cl, footprint.cl, visibility.cl.

/// Lanes that lie behind `plane` as seen from `cop`.
inline vint packet_behind(const SurfelPacket *s, float4 plane, float4 cop) {
    vfloat ahead = plane.w - fma(s->x, (vfloat)(plane.x), fma(s->y, (vfloat)(plane.y), s->z * plane.z));
    float side = plane_ahead(plane, cop) > 0.0f ? 1.0f : -1.0f;
    return PACKET_MASK(ahead * side <= -PLANE_TOLERANCE);
}

/// Lanes whose line from `cop` passes through the triangle or its border; `side` is the sign of plane_ahead(cop).
inline vint packet_meets_triangle(const SurfelPacket *s, global const Triangle *t, float4 cop, float side) {
    float4 a = t->v0 - cop, b = t->v1 - cop, c = t->v2 - cop;
    float4 ab = edge_normal(a, b) * side, bc = edge_normal(b, c) * side, ca = edge_normal(c, a) * side;
    vfloat x = s->x - cop.x, y = s->y - cop.y, z = s->z - cop.z;
    return PACKET_MASK(fma(x, (vfloat)(ab.x), fma(y, (vfloat)(ab.y), z * ab.z)) >= 0.0f) &
           PACKET_MASK(fma(x, (vfloat)(bc.x), fma(y, (vfloat)(bc.y), z * bc.z)) >= 0.0f) &
           PACKET_MASK(fma(x, (vfloat)(ca.x), fma(y, (vfloat)(ca.y), z * ca.z)) >= 0.0f);
}

/// Those of `lanes` whose segment from `cop` crosses triangle `index` or one of its mates in front of the surfel.
inline vint packet_crosses(const SurfelPacket *s, const VisibilityMap *map, int index, float4 cop, vint lanes) {
    global const Triangle *triangle = map->triangles + index;
    float4 plane = map->planes[triangle->plane];
    float ahead = plane_ahead(plane, cop);
    lanes &= packet_behind(s, plane, cop);
    if (ahead == 0.0f || !PACKET_ANY(lanes)) return (vint)(0);
    vint crosses = 0;
#pragma unroll 1
    for (int t = -(triangle->mates & 0xff); t <= triangle->mates >> 8; ++t)
        crosses |= packet_meets_triangle(s, triangle + t, cop, ahead > 0.0f ? 1.0f : -1.0f);
    return crosses & lanes;
}

/// Those of `lanes` that are seen past `group`, the triangles about the footprint of each of them.
inline vint seen_past_groups(const SurfelPacket *s, const VisibilityMap *map, Footprint f, int tile, float4 cop, int4 group, vint lanes) {
    int near[4];
    vstore4(group, 0, near);
    int base = tile * PENCIL_TILE_TEXELS(map->n);
    vint shown = 0;
    for (int g = 0; g < 4 && near[g] >= 0; ++g) {
        vint own = PACKET_MASK(s->plane == map->triangles[near[g]].plane) & lanes;
        if (PACKET_ANY(own))
            for (int rest = PACKET_BITS(own), l; rest; rest &= rest - 1) {
                l = LOWEST_LANE(rest);
                if (((global const int *)(map->groups + base + LANE_INT(f.index, l)))[g] & GROUP_INNER)
                    shown |= PACKET_FROM_BITS(rest & -rest);
            }
        lanes &= ~packet_crosses(s, map, near[g], cop, lanes & ~own);
        if (!PACKET_ANY(lanes)) return lanes;
    }
    int unsure = PACKET_BITS(lanes & ~shown), hidden = 0;
    for (; unsure; unsure &= unsure - 1) {
        int l = LOWEST_LANE(unsure);
        if (hiding_weight(map, tile, footprint_corner(f, l), LANE_FLOAT(f.fx, l), LANE_FLOAT(f.fy, l), cop, surfel_position(s, l),
                          LANE_INT(s->plane, l)) > 0.5f)
            hidden |= 1 << l;
    }
    return lanes & ~PACKET_FROM_BITS(hidden);
}

/// Those of `open` that are seen although their cells do not settle it, by rules 1 to 3 of visibility.cl.
inline vint settle_lanes(const SurfelPacket *s, const VisibilityMap *map, Footprint f, int tile, float4 cop, vint open) {
    int base = tile * PENCIL_TILE_TEXELS(map->n);
    int lanes = PACKET_BITS(open), crowded = 0;
    vint seen = 0;
    while (lanes) {
        int4 group = GROUP_TRIANGLE(map->groups[base + LANE_INT(f.index, LOWEST_LANE(lanes))]);
        int alike = 0;
        for (int rest = lanes; rest; rest &= rest - 1)
            if (all(GROUP_TRIANGLE(map->groups[base + LANE_INT(f.index, LOWEST_LANE(rest))]) == group)) alike |= rest & -rest;
        lanes &= ~alike;
        if (group.x == CELL_MIXED)
            crowded = alike;
        else
            seen |= seen_past_groups(s, map, f, tile, cop, group, PACKET_FROM_BITS(alike));
    }
    int shown = 0;
    for (; crowded; crowded &= crowded - 1) {
        int l = LOWEST_LANE(crowded);
        if (crowded_footprint_visible(map, tile, footprint_corner(f, l), LANE_FLOAT(f.fx, l), LANE_FLOAT(f.fy, l), cop,
                                      surfel_position(s, l), LANE_INT(s->plane, l)))
            shown |= 1 << l;
    }
    return seen | PACKET_FROM_BITS(shown);
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

    // The one plane that can hide the surfel: that which fills the cell, or the other of a pair.
    vint pair = CELL_PAIR(second);
    vint filled = PACKET_MASK(first == second) & PACKET_MASK(first >= 0);
    vint blocker = select((vint)(CELL_MIXED), first, filled | PACKET_MASK(pair == s->plane));
    blocker = select(blocker, pair, at_first & PACKET_MASK(second <= CELL_PAIR(0)));
    vint behind = 0;
    vint blocked = open & PACKET_MASK(blocker >= 0);
    while (PACKET_ANY(blocked)) {
        int other = LANE_INT(blocker, LOWEST_LANE(PACKET_BITS(blocked)));
        vint alike = blocked & PACKET_MASK(blocker == other);
        behind |= alike & packet_behind(s, map->planes[other], cop);
        blocked &= ~alike;
    }
    seen |= open & PACKET_MASK(blocker >= 0) & ~behind;
    open &= ~seen & ~(behind & filled);  // behind the other of a pair: look at the triangles
    if (!PACKET_ANY(open)) return seen;
    return seen | settle_lanes(s, map, f, tile, cop, open);
}
