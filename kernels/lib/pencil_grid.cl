// The surface pencils near a point, by the grid.

#include "lib/packet.cl"
#include "lib/surface_pencil.cl"
#include "shared/surface_pencil.h"

/// Pencils that one look-up combines at most.
#define LINKS 4

/// The best pencils at a point and their weights, which sum to 1; index -1 and weight 0 where there are fewer. Where none may be used, the
/// nearest that faces the same way and has a clear horizon: in the narrowest corners something must stand for the light.
typedef struct PencilLinks {
    int index[LINKS];
    float weight[LINKS];
} PencilLinks;

static inline void insert_link(PencilLinks *links, int index, float weight) {
    for (int k = 0; k < LINKS; ++k)
        if (weight > links->weight[k]) {
            float w = links->weight[k];
            int i = links->index[k];
            links->weight[k] = weight;
            links->index[k] = index;
            weight = w;
            index = i;
        }
}

/// Entries of one block within whose radius x lies and that face the same way; `level`: those of them on whose surface x lies.
static inline int block_reaches(global const float *block, float3 x, float3 n, vfloat *distance, vfloat *cosine, int *level) {
    vfloat sx = x.x - PACKET_LOAD(block + ENTRY_X * PENCIL_WIDTH), sy = x.y - PACKET_LOAD(block + ENTRY_Y * PENCIL_WIDTH),
           sz = x.z - PACKET_LOAD(block + ENTRY_Z * PENCIL_WIDTH);
    vfloat nx = PACKET_LOAD(block + ENTRY_NX * PENCIL_WIDTH), ny = PACKET_LOAD(block + ENTRY_NY * PENCIL_WIDTH),
           nz = PACKET_LOAD(block + ENTRY_NZ * PENCIL_WIDTH);
    *distance = sqrt(fma(sx, sx, fma(sy, sy, sz * sz)));
    *cosine = fma(nx, (vfloat)(n.x), fma(ny, (vfloat)(n.y), nz * n.z));
    vfloat rise = fma(sx, nx + n.x, fma(sy, ny + n.y, sz * (nz + n.z)));
    vint reaches = PACKET_MASK(*distance < PACKET_LOAD(block + ENTRY_RADIUS * PENCIL_WIDTH)) & PACKET_MASK(*cosine >= REUSE_LEAST_COSINE);
    *level = PACKET_BITS(reaches & PACKET_MASK(fabs(rise) <= 2.0f * REUSE_MOST_SLOPE * *distance + position_error(x)));
    return PACKET_BITS(reaches);
}

/// The nearest pencil that may stand for a point where no other does.
typedef struct LastResort {
    int index;  // -1: none
    float distance;
} LastResort;

/// The pencils of one slot of the grid.
static inline void link_slot(global const SurfacePencil *pencils, global const float *entries, int first, int end, float3 x, float3 n,
                             PencilLinks *links, LastResort *last) {
    for (int e = first; e < end; ++e) {
        global const float *block = entries + (size_t)e * (ENTRY_FIELDS * PENCIL_WIDTH);
        global const int *index = (global const int *)(block + ENTRY_PENCIL * PENCIL_WIDTH);
        vfloat distance, cosine;
        int level, reached = block_reaches(block, x, n, &distance, &cosine, &level);
        vfloat radius = PACKET_LOAD(block + ENTRY_RADIUS * PENCIL_WIDTH);
        vfloat closeness = fmax(1.0f / radius - distance / (radius * radius), (vfloat)(0.0f));
        vfloat weight = closeness * closeness * cosine;
        for (int bits = level; bits; bits &= bits - 1) {
            int l = LOWEST_LANE(bits);
            float own = LANE_FLOAT(weight, l);
            if (!(own > links->weight[LINKS - 1])) continue;  // the horizon costs more than all before
            global const SurfacePencil *p = pencils + index[l];
            if (clear_horizon(p, x - p->position.xyz)) insert_link(links, index[l], own);
        }
        for (int bits = links->index[0] < 0 ? reached : 0; bits; bits &= bits - 1) {
            int l = LOWEST_LANE(bits);
            global const SurfacePencil *p = pencils + index[l];
            if (LANE_FLOAT(distance, l) >= last->distance || !clear_horizon(p, x - p->position.xyz)) continue;
            last->distance = LANE_FLOAT(distance, l);
            last->index = index[l];
        }
    }
}

/// The pencil that faces the same way and comes nearest to x in terms of its radius, -1 if none faces so: for the few points beyond the reach
/// of all. Light that no pencil stands for would be lost, in every reflection.
static inline int least_far_pencil(global const SurfacePencil *pencils, int count, float3 x, float3 n) {
    float least = INFINITY;
    int found = -1;
    for (int i = 0; i < count; ++i) {
        float3 step = x - pencils[i].position.xyz;
        float radius = pencils[i].normal.w, far = dot(step, step) / (radius * radius);
        if (!(far < least) || dot(pencils[i].normal.xyz, n) < REUSE_LEAST_COSINE) continue;
        least = far;
        found = i;
    }
    return found;
}

static inline PencilLinks nearest_pencils(global const SurfacePencil *pencils, PencilGrid grid, global const int *starts,
                                          global const float *entries, float3 x, float3 n) {
    PencilLinks links = {{-1, -1, -1, -1}, {0.0f, 0.0f, 0.0f, 0.0f}};
    LastResort last = {-1, INFINITY};
    float3 at = (x - grid.origin.xyz) * grid.origin.w;
    float weight = grid.origin.w * grid.origin.w / (PENCIL_GRID_REACH * PENCIL_GRID_REACH);
    for (int level = 0; level < grid.levels; ++level, at *= 0.5f, weight *= 0.25f) {
        int3 cell = convert_int3_sat_rtn(at);
        int slot = PENCIL_GRID_SLOT(cell.x, cell.y, cell.z, level, grid.slots);
        link_slot(pencils, entries, starts[slot], starts[slot + 1], x, n, &links, &last);
        // Wider pencils weigh 1 / radius^2 at most, and their radii exceed PENCIL_GRID_REACH cells of this level.
        if (links.weight[LINKS - 1] >= weight) break;
    }
    float sum = links.weight[0] + links.weight[1] + links.weight[2] + links.weight[3];
    for (int k = 0; k < LINKS; ++k) links.weight[k] = sum > 0.0f ? links.weight[k] / sum : 0.0f;
    if (sum == 0.0f && last.index < 0) last.index = least_far_pencil(pencils, grid.count, x, n);
    if (sum == 0.0f && last.index >= 0) {
        links.index[0] = last.index;
        links.index[1] = LINK_LAST_RESORT;
        links.weight[0] = 1.0f;
    }
    return links;
}

/// The weighted mean of the linked pencils' irradiance, 0 where there are none.
static inline float3 linked_irradiance(global const float4 *irradiance, PencilLinks links) {
    float3 sum = (float3)(0.0f);
    for (int k = 0; k < LINKS && links.index[k] >= 0; ++k) sum += links.weight[k] * irradiance[links.index[k]].xyz;
    return sum;
}
