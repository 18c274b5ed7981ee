// The surface pencils near a point, by the grid. Needs surface_pencil.cl.

/// Pencils that one look-up combines at most.
#define LINKS 4

/// The best pencils at a point and their weights, which sum to 1; index -1 and weight 0 where there are fewer. Where none may be used, the
/// nearest that faces the same way: in the narrowest corners something must stand for the light.
typedef struct PencilLinks {
    int index[LINKS];
    float weight[LINKS];
} PencilLinks;

inline PencilLinks nearest_pencils(global const SurfacePencil *pencils, PencilGrid grid, global const int *starts,
                                   global const int *entries, float3 x, float3 n) {
    PencilLinks links = {{-1, -1, -1, -1}, {0.0f, 0.0f, 0.0f, 0.0f}};
    int3 cell = convert_int3((x - grid.low.xyz) * grid.low.w);
    cell = clamp(cell, (int3)(0), (int3)(grid.size_x - 1, grid.size_y - 1, grid.size_z - 1));
    int at = (cell.z * grid.size_y + cell.y) * grid.size_x + cell.x;
    float least = INFINITY;
    int last = -1;
    for (int e = starts[at]; e < starts[at + 1]; ++e) {
        global const SurfacePencil *p = pencils + entries[e];
        float3 step = x - p->position.xyz;
        float square = dot(step, step);
        if (square < least && square < p->normal.w * p->normal.w && dot(p->normal.xyz, n) >= REUSE_LEAST_COSINE) {
            least = square;
            last = entries[e];
        }
        float reach = 1.0f - reuse_distance(p, x, n, p->normal.w) / p->normal.w;
        if (!(reach > 0.0f)) continue;
        float weight = reach * reach * dot(p->normal.xyz, n);
        for (int k = 0, index = entries[e]; k < LINKS; ++k)
            if (weight > links.weight[k]) {
                float w = links.weight[k];
                int i = links.index[k];
                links.weight[k] = weight;
                links.index[k] = index;
                weight = w;
                index = i;
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

inline float3 linked_irradiance(global const SurfacePencil *pencils, PencilLinks links) {
    float3 sum = (float3)(0.0f);
    for (int k = 0; k < LINKS && links.index[k] >= 0; ++k) sum += links.weight[k] * pencils[links.index[k]].irradiance.xyz;
    return sum;
}
