// The far end of a line through a pencil and a surfel: where the light comes from that the pencil passes on. The bilinear mean of the texels
// that show it, exact at silhouettes: light of one surface is not spread over another, whose lines are rarer or more frequent.

#include "lib/atlas.cl"
#include "lib/footprint.cl"
#include "lib/map.cl"
#include "lib/projection.cl"
#include "lib/surfel_packet.cl"
#include "lib/triangle.cl"
#include "lib/visibility.cl"
#include "shared/atlas.h"

/// Triangle of the four texels from `corner` that a ray from `cop` along `direction` meets first, -1: none.
static inline int met_triangle(const VisibilityMap *map, int tile, int2 corner, float4 cop, float4 direction) {
    int nearest = -1;
    float most = 0.0f;
    for (int k = 0; k < 4; ++k) {
        int index = map->hits[map_atlas_index(tile, map_footprint_texel(corner, k, map->n), map->n)].triangle;
        if (index < 0 || index == nearest) continue;
        float4 plane = map->planes[map->triangles[index].plane];
        float ahead = plane_ahead(plane, cop);
        float disparity = dot(plane.xyz, direction.xyz) / ahead;
        if (!(disparity > most) || !line_meets_triangle(map->triangles + index, cop, direction, ahead > 0.0f ? 1.0f : -1.0f)) continue;
        nearest = index;
        most = disparity;
    }
    return nearest;
}

/// Path from `cop` along `direction` to a plane.
static inline float path_to_plane(float4 plane, float4 cop, float4 direction) {
    return length(direction.xyz) * plane_ahead(plane, cop) / dot(plane.xyz, direction.xyz);
}

/// Radiance (rgb), bilinear over those texels from `corner`, in the direction away from the surfel, that show what the ray meets, and the path
/// to there (w); those of the nearest texel where no texel shows it. (fx, fy): bilinear weights.
static inline float4 mixed_far_end(const VisibilityMap *map, RADIANCE_ATLAS radiance, int tile, int2 corner, float fx, float fy, float4 cop,
                                   float4 direction) {
    int met = met_triangle(map, tile, corner, cop, direction);
    int plane = met < 0 ? -1 : map->triangles[met].plane;
    float4 sum = (float4)(0.0f), nearest = sum;
    float total = 0.0f, most = -1.0f;
    for (int k = 0; k < 4; ++k) {
        int2 texel = map_footprint_texel(corner, k, map->n);
        int triangle = map->hits[map_atlas_index(tile, texel, map->n)].triangle;
        float4 light = radiance_texel(radiance, tile, map_antipode(texel, map->n), map->n);
        float weight = (k & 1 ? fx : 1.0f - fx) * (k >> 1 ? fy : 1.0f - fy);
        if (weight > most) {
            most = weight;
            nearest = light;
        }
        if (met < 0 || triangle < 0 || map->triangles[triangle].plane != plane) continue;
        sum += weight * light;
        total += weight;
    }
    if (!(total > 0.0f)) return nearest;
    return (float4)(sum.xyz / total, path_to_plane(map->planes[plane], cop, direction));
}

/// Radiance (rgb) that lane `l` of a packet receives which is aimed at a centre, and the path from there to its far end (w). `back`: the
/// footprint of the direction away from the surfel, `direction`, in the same tile.
static inline float4 far_end(const VisibilityMap *map, RADIANCE_ATLAS radiance, int tile, const Footprint *aimed, const Footprint *back,
                             int l, float4 cop, float4 direction) {
    int2 cell = map->cells[LANE_INT(back->index, l) + tile * MAP_STORED(map->n)];
    if (cell.x != cell.y || cell.x < 0)
        return mixed_far_end(map, radiance, tile, footprint_corner(back, l), LANE_FLOAT(back->fx, l), LANE_FLOAT(back->fy, l), cop,
                             direction);
    float4 light = fetch_radiance(radiance, tile, aimed, l, PENCIL_TILE_STRIDE(map->n));
    light.w = path_to_plane(map->planes[cell.x], cop, direction);
    return light;
}

/// far_end of those of `lanes` that see the centre of a tile that they are aimed at.
static inline void far_ends(const SurfelPacket *s, const VisibilityMap *map, RADIANCE_ATLAS radiance, int tile, const Footprint *aimed,
                            float4 cop, int lanes, float4 *light) {
    Footprint back = map_footprint(cop.x - s->x, cop.y - s->y, cop.z - s->z, map->n);
    for (; lanes; lanes &= lanes - 1) {
        int l = LOWEST_LANE(lanes);
        light[l] = far_end(map, radiance, tile, aimed, &back, l, cop, cop - surfel_position(s, l));
    }
}
