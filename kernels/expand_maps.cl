// Maps whose light or weights were made at a coarser size, brought to the size of the geometry maps by which they are looked up.

#include "lib/map.cl"
#include "lib/packet.cl"
#include "shared/atlas.h"
#include "shared/geometry.h"

/// Bilinear weight of coarse texels that show the surface of a texel, from which on others are left out.
#define LEAST_ALIKE 0.02f

/// Plane that is seen through a texel of tile `tile`, -1: none.
static inline int plane_of_texel(global const Hit *hits, global const Triangle *triangles, int tile, int2 texel, int n) {
    int triangle = hits[map_atlas_index(tile, texel, n)].triangle;
    return triangle < 0 ? -1 : triangles[triangle].plane;
}

/// Texel through which the surface is seen that a value belongs to: light comes from behind, weights are those of the surface ahead.
static inline int2 looks_through(int2 texel, int n, int part) { return part ? texel : map_antipode(texel, n); }

/// Of a texel whose surface has plane `plane`: the bilinear mean of the four coarse texels about footprint lane l, of those alone whose surface has
/// the same where there are any.
static inline float4 expanded(const Footprint *f, int l, int tile, int plane, global const float4 *coarse, global const Hit *coarse_hits,
                              global const Triangle *triangles, int m, int part) {
    int2 corner = footprint_corner(f, l);
    float fx = LANE_FLOAT(f->fx, l), fy = LANE_FLOAT(f->fy, l), alike = 0.0f;
    float4 same = (float4)(0.0f), all = (float4)(0.0f);
    for (int k = 0; k < 4; ++k) {
        int2 texel = map_footprint_texel(corner, k, m);
        float weight = (k & 1 ? fx : 1.0f - fx) * (k >> 1 ? fy : 1.0f - fy);
        float4 value = coarse[map_atlas_index(tile, texel, m)];
        all += weight * value;
        if (plane_of_texel(coarse_hits, triangles, tile, looks_through(texel, m, part), m) != plane) continue;
        same += weight * value;
        alike += weight;
    }
    return alike < LEAST_ALIKE ? all : same / alike;
}

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH texels of tiles first_tile .. , gutters included
/// in     : coarse and its coarse_hits, atlas layouts of maps of m x m; hits of maps of n x n; triangles; part: 0 light, 1 weights
/// out    : radiance, atlas layout of n x n: rgb or w of the texels; with rgb gutters get the w of what they repeat
kernel void expand_maps(global const float4 *coarse, global const Hit *coarse_hits, int m, global const Hit *hits,
                        global const Triangle *triangles, int first_tile, int tile_count, int n, int part, global float4 *radiance) {
    int first = get_global_id(0) * PENCIL_WIDTH, texels = MAP_STORED(n), stride = PENCIL_TILE_STRIDE(n);
    if (first >= tile_count * texels) return;
    float x[PENCIL_WIDTH], y[PENCIL_WIDTH], z[PENCIL_WIDTH];
    int2 inside[PENCIL_WIDTH];
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        int item = min(first + l, tile_count * texels - 1) % texels;
        inside[l] = map_texel_beside((int2)(item % stride, item / stride) - PENCIL_GUTTER, (int2)(0), n);
        float4 direction = map_texel_direction(inside[l], n);
        x[l] = direction.x;
        y[l] = direction.y;
        z[l] = direction.z;
    }
    Footprint f = map_footprint(PACKET_LOAD(x), PACKET_LOAD(y), PACKET_LOAD(z), m);
    for (int l = 0; l < PENCIL_WIDTH && first + l < tile_count * texels; ++l) {
        int tile = first_tile + (first + l) / texels;
        int plane = plane_of_texel(hits, triangles, tile, looks_through(inside[l], n, part), n);
        float4 value = expanded(&f, l, tile, plane, coarse, coarse_hits, triangles, m, part);
        global float4 *out = radiance + (size_t)first_tile * texels + first + l;
        if (part)
            out->w = value.w;
        else
            *out = (float4)(value.xyz, radiance[map_atlas_index(tile, inside[l], n)].w);
    }
}
