// Geometry maps of any kind by packets of rays through the hierarchy: what rasterize_octahedral.cl draws, ties of rounding apart.

#include "lib/bvh.cl"
#include "lib/map.cl"
#include "lib/packet.cl"
#include "lib/triangle.cl"
#include "shared/atlas.h"
#include "shared/bvh.h"
#include "shared/geometry.h"

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH texels of tiles first_tile .. ; a tile's texels in the order of map_block_texel
/// in     : cops[first_tile + tile] (xyz, scene units); the scene and its hierarchy
/// out    : hits, atlas layout, interior texels; disparity for a direction as long as map_texel_direction
/// needs  : n a multiple of 4
kernel void trace_maps(HIERARCHY_PARAMETERS, global const Triangle *triangles, global const float4 *planes, global const float4 *cops,
                       int first_tile, int tile_count, int n, global Hit *hits) {
    int packet = get_global_id(0);
    int packets = MAP_TEXELS(n) / PENCIL_WIDTH;
    if (packet >= tile_count * packets) return;
    int tile = first_tile + packet / packets;
    int first = packet % packets * PENCIL_WIDTH;
    float4 cop = (float4)(cops[tile].xyz, 0.0f);
    float x[PENCIL_WIDTH], y[PENCIL_WIDTH], z[PENCIL_WIDTH];
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        float4 direction = map_texel_direction(map_block_texel(first + l, n), n);
        x[l] = direction.x;
        y[l] = direction.y;
        z[l] = direction.z;
    }
    RayPacket rays = ray_packet(PACKET_LOAD(x), PACKET_LOAD(y), PACKET_LOAD(z));
    packet_trace(&rays, cop, -1, PLANE_TOLERANCE, nodes, leaves, triangles, planes);
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        global Hit *hit = hits + (size_t)tile * MAP_STORED(n) + map_atlas_index(0, map_block_texel(first + l, n), n);
        hit->triangle = LANE_INT(rays.triangle, l);
        hit->disparity = LANE_FLOAT(rays.disparity, l);
    }
}
