// The surface pencil that stands for a point which none reaches: light that no pencil stands for would be lost, in every reflection. Pencils know
// what is at their horizon, but not what lies behind the next wall, so rays decide: both must see a place between them.

#include "lib/apart.cl"
#include "lib/pencil_grid.cl"
#include "lib/rays.cl"

/// Candidates that rays are sent from: nearest first.
#define STAND_INS 8
/// The place between lies so far above the surfaces of both, in terms of their distance.
#define STAND_IN_LIFT 0.03f

typedef struct StandIns {
    int index[STAND_INS];     // -1: none
    float square[STAND_INS];  // of its distance
} StandIns;

static inline void no_stand_ins(StandIns *found) {
    for (int k = 0; k < STAND_INS; ++k) {
        found->index[k] = -1;
        found->square[k] = INFINITY;
    }
}

/// Pencil i joins the nearest if it is likely to receive what x does: it faces the same way, and nothing is at its horizon.
static inline void consider_pencil(global const SurfacePencil *pencils, int i, float3 x, float3 n, StandIns *found) {
    global const SurfacePencil *p = pencils + i;
    float3 step = x - p->position.xyz;
    float square = dot(step, step);
    if (!(square < found->square[STAND_INS - 1]) || dot(p->normal.xyz, n) < REUSE_LEAST_COSINE || !clear_horizon(p, step)) return;
    int k = STAND_INS - 1;
    for (; k > 0 && square < found->square[k - 1]; --k) {
        found->index[k] = found->index[k - 1];
        found->square[k] = found->square[k - 1];
    }
    found->index[k] = i;
    found->square[k] = square;
}

/// Those whose cells x lies in.
static inline void consider_cells(global const SurfacePencil *pencils, PencilGrid grid, global const int *starts,
                                  global const float *entries, float3 x, float3 n, StandIns *found) {
    float3 at = (x - grid.origin.xyz) * grid.origin.w;
    float diagonal = 1.7321f / grid.origin.w;
    for (int level = 0; level < grid.levels; ++level, at /= PENCIL_GRID_STEP, diagonal *= PENCIL_GRID_STEP)
        for (int slot = pencil_slot(grid, at, level), e = starts[slot] * PENCIL_WIDTH; e < starts[slot + 1] * PENCIL_WIDTH; ++e) {
            global const float *entry = entries + (size_t)(e / PENCIL_WIDTH) * (ENTRY_FIELDS * PENCIL_WIDTH) + e % PENCIL_WIDTH;
            float radius = entry[ENTRY_RADIUS * PENCIL_WIDTH];
            if (!(radius > 0.0f)) continue;
            int i = ((global const int *)entry)[ENTRY_PENCIL * PENCIL_WIDTH];
            // Others only share the slot.
            if (distance(x, pencils[i].position.xyz) <= radius + diagonal) consider_pencil(pencils, i, x, n, found);
        }
}

/// Some that are spread among all: to look at all of them costs more than such light is worth.
static inline void consider_all(global const SurfacePencil *pencils, PencilGrid grid, float3 x, float3 n, StandIns *found) {
    uint count = grid.count, stride = count % PENCIL_GRID_STRIDE == 0 ? 1 : PENCIL_GRID_STRIDE;
    for (uint k = 0; k < count && (k < PENCIL_GRID_LOOK || found->index[0] < 0); ++k)
        consider_pencil(pencils, (int)((ulong)k * stride % count), x, n, found);
}

/// A place before the surfaces of both points, as near to the middle between them as may be.
static inline float3 place_between(float3 x, float3 n, float3 y, float3 m) {
    float3 middle = 0.5f * (x + y), up = normalize(n + m);
    float rise = fmax(dot(x - middle, n) / dot(up, n), dot(y - middle, m) / dot(up, m));
    return middle + (fmax(rise, 0.0f) + STAND_IN_LIFT * distance(x, y)) * up;
}

/// The nearest of the candidates that sees, as x does, the place between them; -1 if none does.
static inline int first_in_sight(global const SurfacePencil *pencils, const StandIns *found, float3 x, float3 n, float3 g, int plane,
                                 HIERARCHY_PARAMETERS, global const Triangle *triangles, global const float4 *planes) {
    // Rays 2 k and 2 k + 1: from x, and from candidate k.
    float o[3][2 * STAND_INS], d[3][2 * STAND_INS], end[2 * STAND_INS];
    int own[2 * STAND_INS], clear[2 * STAND_INS];
    for (int r = 0; r < 2 * STAND_INS; ++r) {
        int i = found->index[r / 2];
        global const SurfacePencil *p = pencils + max(i, 0);
        float3 from = r % 2 == 0 ? x : p->position.xyz, step = place_between(x, n, p->position.xyz, p->normal.xyz) - from;
        o[0][r] = from.x;
        o[1][r] = from.y;
        o[2][r] = from.z;
        d[0][r] = step.x;
        d[1][r] = step.y;
        d[2][r] = step.z;
        own[r] = r % 2 == 0 ? plane : p->plane;
        bool ahead = dot(step, r % 2 == 0 ? g : p->facing.xyz) > 0.0f;  // rays do not meet what they start on
        end[r] = i >= 0 && ahead ? 1.0f : -1.0f;
    }
    for (int r = 0; r < 2 * STAND_INS; r += PENCIL_WIDTH) {
        LaneRays rays = lane_rays(PACKET_LOAD(o[0] + r), PACKET_LOAD(o[1] + r), PACKET_LOAD(o[2] + r), PACKET_LOAD(d[0] + r),
                                  PACKET_LOAD(d[1] + r), PACKET_LOAD(d[2] + r), PACKET_LOAD(own + r), PACKET_LOAD(end + r));
        lanes_trace(&rays, true, nodes, leaves, triangles, planes);
        PACKET_STORE(select(rays.triangle, (vint)(0), PACKET_MASK(PACKET_LOAD(end + r) < 0.0f)), clear + r);
    }
    for (int k = 0; k < STAND_INS && found->index[k] >= 0; ++k)
        if (clear[2 * k] < 0 && clear[2 * k + 1] < 0) return found->index[k];
    return -1;
}

/// The links of a point. Where none may be used, another stands in, if there is one: then index[1] is LINK_STANDS_IN. g: geometric normal;
/// `plane`: that x lies on.
APART static PencilLinks nearest_pencils(global const SurfacePencil *pencils, PencilGrid grid, global const int *starts,
                                         global const float *entries, float3 x, float3 n, float3 g, int plane, HIERARCHY_PARAMETERS,
                                         global const Triangle *triangles, global const float4 *planes) {
    PencilLinks links = reaching_pencils(pencils, grid, starts, entries, x, n);
    if (links.index[0] >= 0) return links;
    StandIns found;
    no_stand_ins(&found);
    consider_cells(pencils, grid, starts, entries, x, n, &found);
    int chosen = first_in_sight(pencils, &found, x, n, g, plane, nodes, leaves, triangles, planes);
    if (chosen < 0) {
        no_stand_ins(&found);
        consider_all(pencils, grid, x, n, &found);
        chosen = first_in_sight(pencils, &found, x, n, g, plane, nodes, leaves, triangles, planes);
    }
    if (chosen < 0) return links;
    links.index[0] = chosen;
    links.index[1] = LINK_STANDS_IN;
    links.weight[0] = 1.0f;
    return links;
}
