// The surface pencils near a point, by the grid.

#include "lib/packet.cl"
#include "lib/surface_pencil.cl"
#include "shared/surface_pencil.h"

/// Pencils that one look-up combines at most.
#define LINKS 4

/// The best pencils at a point and their weights, which sum to 1; index -1 and weight 0 where there are fewer.
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

/// Entries of one block within whose radius x lies, on their surface, and that face the same way, with their distance and cosine.
static inline int block_reaches(global const float *block, float3 x, float3 n, vfloat *distance, vfloat *cosine) {
    vfloat sx = x.x - PACKET_LOAD(block + ENTRY_X * PENCIL_WIDTH), sy = x.y - PACKET_LOAD(block + ENTRY_Y * PENCIL_WIDTH),
           sz = x.z - PACKET_LOAD(block + ENTRY_Z * PENCIL_WIDTH);
    vfloat nx = PACKET_LOAD(block + ENTRY_NX * PENCIL_WIDTH), ny = PACKET_LOAD(block + ENTRY_NY * PENCIL_WIDTH),
           nz = PACKET_LOAD(block + ENTRY_NZ * PENCIL_WIDTH);
    *distance = sqrt(fma(sx, sx, fma(sy, sy, sz * sz)));
    *cosine = fma(nx, (vfloat)(n.x), fma(ny, (vfloat)(n.y), nz * n.z));
    vfloat rise = fma(sx, nx + n.x, fma(sy, ny + n.y, sz * (nz + n.z)));
    return PACKET_BITS(PACKET_MASK(*distance < PACKET_LOAD(block + ENTRY_RADIUS * PENCIL_WIDTH)) &
                       PACKET_MASK(*cosine >= REUSE_LEAST_COSINE) &
                       PACKET_MASK(fabs(rise) <= 2.0f * REUSE_MOST_SLOPE * *distance + position_error(x)));
}

/// The pencils of one slot of the grid.
static inline void link_slot(global const SurfacePencil *pencils, global const float *entries, int first, int end, float3 x, float3 n,
                             PencilLinks *links) {
    for (int e = first; e < end; ++e) {
        global const float *block = entries + (size_t)e * (ENTRY_FIELDS * PENCIL_WIDTH);
        global const int *index = (global const int *)(block + ENTRY_PENCIL * PENCIL_WIDTH);
        vfloat distance, cosine;
        int bits = block_reaches(block, x, n, &distance, &cosine);
        vfloat radius = PACKET_LOAD(block + ENTRY_RADIUS * PENCIL_WIDTH);
        vfloat closeness = fmax(1.0f / radius - distance / (radius * radius), (vfloat)(0.0f));
        vfloat weight = closeness * closeness * cosine;
        for (; bits; bits &= bits - 1) {
            int l = LOWEST_LANE(bits);
            float own = LANE_FLOAT(weight, l);
            if (!(own > links->weight[LINKS - 1])) continue;  // the horizon costs more than all before
            global const SurfacePencil *p = pencils + index[l];
            if (clear_horizon(p, x - p->position.xyz)) insert_link(links, index[l], own);
        }
    }
}

/// Slot of a cell; `at`: a place in it, in terms of the cells of its level.
static inline int pencil_slot(PencilGrid grid, float3 at, int level) {
    int3 cell = convert_int3_sat_rtn(at);
    return PENCIL_GRID_SLOT(cell.x, cell.y, cell.z, level, grid.slots);
}

/// The links of a point; index[0] is -1 where no pencil may be used.
static inline PencilLinks reaching_pencils(global const SurfacePencil *pencils, PencilGrid grid, global const int *starts,
                                           global const float *entries, float3 x, float3 n) {
    PencilLinks links = {{-1, -1, -1, -1}, {0.0f, 0.0f, 0.0f, 0.0f}};
    float3 at = (x - grid.origin.xyz) * grid.origin.w;
    float weight = grid.origin.w * grid.origin.w / (PENCIL_GRID_REACH * PENCIL_GRID_REACH);
    for (int level = 0; level < grid.levels; ++level, at /= PENCIL_GRID_STEP, weight /= PENCIL_GRID_STEP * PENCIL_GRID_STEP) {
        int slot = pencil_slot(grid, at, level);
        link_slot(pencils, entries, starts[slot], starts[slot + 1], x, n, &links);
        // Wider pencils weigh 1 / radius^2 at most, and their radii exceed PENCIL_GRID_REACH cells of this level.
        if (links.weight[LINKS - 1] >= weight) break;
    }
    float sum = links.weight[0] + links.weight[1] + links.weight[2] + links.weight[3];
    for (int k = 0; k < LINKS; ++k) links.weight[k] = sum > 0.0f ? links.weight[k] / sum : 0.0f;
    return links;
}

/// The weighted mean of the linked pencils' irradiance, 0 where there are none.
static inline float3 linked_irradiance(global const float4 *irradiance, PencilLinks links) {
    float3 sum = (float3)(0.0f);
    for (int k = 0; k < LINKS && links.index[k] >= 0; ++k) sum += links.weight[k] * irradiance[links.index[k]].xyz;
    return sum;
}
