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
    *level = PACKET_BITS(reaches & PACKET_MASK(fabs(rise) <= 2.0f * REUSE_MOST_SLOPE * *distance + REUSE_TINY));
    return PACKET_BITS(reaches);
}

static inline PencilLinks nearest_pencils(global const SurfacePencil *pencils, PencilGrid grid, global const int *starts,
                                   global const float *entries, float3 x, float3 n) {
    PencilLinks links = {{-1, -1, -1, -1}, {0.0f, 0.0f, 0.0f, 0.0f}};
    int3 cell = convert_int3((x - grid.low.xyz) * grid.low.w);
    cell = clamp(cell, (int3)(0), (int3)(grid.size_x - 1, grid.size_y - 1, grid.size_z - 1));
    int at = (cell.z * grid.size_y + cell.y) * grid.size_x + cell.x;
    float least = INFINITY;
    int last = -1;
    for (int e = starts[at]; e < starts[at + 1]; ++e) {
        global const float *block = entries + (size_t)e * (ENTRY_FIELDS * PENCIL_WIDTH);
        global const int *index = (global const int *)(block + ENTRY_PENCIL * PENCIL_WIDTH);
        vfloat distance, cosine;
        int level, reached = block_reaches(block, x, n, &distance, &cosine, &level);
        vfloat radius = PACKET_LOAD(block + ENTRY_RADIUS * PENCIL_WIDTH);
        vfloat closeness = fmax(1.0f / radius - distance / (radius * radius), (vfloat)(0.0f));
        vfloat weight = closeness * closeness * cosine;
        for (int bits = level; bits; bits &= bits - 1) {
            int l = LOWEST_LANE(bits);
            global const SurfacePencil *p = pencils + index[l];
            if (clear_horizon(p, x - p->position.xyz)) insert_link(&links, index[l], LANE_FLOAT(weight, l));
        }
        for (int bits = links.index[0] < 0 ? reached : 0; bits; bits &= bits - 1) {
            int l = LOWEST_LANE(bits);
            global const SurfacePencil *p = pencils + index[l];
            if (LANE_FLOAT(distance, l) >= least || !clear_horizon(p, x - p->position.xyz)) continue;
            least = LANE_FLOAT(distance, l);
            last = index[l];
        }
    }
    float sum = links.weight[0] + links.weight[1] + links.weight[2] + links.weight[3];
    for (int k = 0; k < LINKS; ++k) links.weight[k] = sum > 0.0f ? links.weight[k] / sum : 0.0f;
    if (sum == 0.0f && last >= 0) {
        links.index[0] = last;
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
