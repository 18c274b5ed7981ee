// Follows light back along the lobes of surfaces (mirrors, glass, gloss): a surfel with lobes is replaced by what a chain of scattered rays ends
// on. At each surface the chain stops, which stands for the base of the surface and for light samples on its lobes, or goes on along its lobes,
// by chance; both count by what is in their place, so that the mean over all chains is exact.

#include "lib/apart.cl"
#include "lib/chain.cl"
#include "lib/rays.cl"
#include "lib/viewer.cl"
#include "shared/surfel.h"

/// Of the packet at `begin`, see below.
APART static void follow_surfels_packet(int begin, global const float *from, int from_capacity, global const int *starts, int listed,
                                        int shared, int balanced, int chain_count, global const SurfacePencil *viewers, int first_viewer,
                                        int texels, global const float *near_first, global const float *near_next, float sky_first,
                                        float sky_next, uint seed, HIERARCHY_PARAMETERS, SURFACES_PARAMETERS, global float *surfels,
                                        int capacity, int first, global float *uneven) {
    Surfaces scene = SURFACES;
    Chain chains[PENCIL_WIDTH];
    bool any_open = false;
#pragma unroll 1
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        Chain *c = chains + l;
        c->open = begin + l < chain_count;
        c->pdf = shared ? 0.0f : -1.0f;  // what the film sees through clear things it sees; hemispheres have light samples for it
        c->on_film = false;
        c->uneven = 0.0f;
        c->negative = false;
        c->bits = hash_uint(seed + hash_uint(seen_number(viewers, first_viewer, c->open ? texels : 0, begin + l)));
        if (!c->open) continue;
        if (shared) {
            uint of_surfel = hash_uint(seed ^ hash_uint((uint)((begin + l) / shared)));
            c->shift = (uint3)(of_surfel, hash_uint(of_surfel), hash_uint(of_surfel ^ 0x5bd1e995u));
            c->number = (begin + l) % shared;
            c->shared = shared;
            c->balanced = balanced;
        }
        int start = listed ? starts[begin + l] : first + begin + l;
        c->at = load_vertex(from, from_capacity, start, materials, bitmaps);
        c->t.factor = surfel_vector(from, from_capacity, start, SURFEL_TR);  // 0 below a pencil's horizon, where no sky is seen
        c->t.share = shared ? 0.0f : -1.0f;                                  // the film shows its own emission
        c->direction = -c->at.o;
        c->open = c->at.plane >= 0 && c->at.bsdf.model != MATERIAL_DIFFUSE;
        any_open |= c->open;
    }
    if (!any_open && !listed) return;
    for (int steps = 0; any_open; ++steps) {
        float o[3][PENCIL_WIDTH], d[3][PENCIL_WIDTH], end[PENCIL_WIDTH];
        int own[PENCIL_WIDTH];
        any_open = false;
#pragma unroll 1
        for (int l = 0; l < PENCIL_WIDTH; ++l) {
            Chain *c = chains + l;
            if (c->open) step_chain(c, shared && steps == 0, steps, materials);
            end[l] = c->open ? INFINITY : -1.0f;
            own[l] = c->open ? c->at.plane : -1;
            for (int k = 0; k < 3; ++k) o[k][l] = d[k][l] = 0.0f;
            if (!c->open) continue;
            any_open = true;
            o[0][l] = c->at.x.x;
            o[1][l] = c->at.x.y;
            o[2][l] = c->at.x.z;
            d[0][l] = c->direction.x;
            d[1][l] = c->direction.y;
            d[2][l] = c->direction.z;
        }
        if (!any_open) break;
        LaneRays rays = lane_rays(PACKET_LOAD(o[0]), PACKET_LOAD(o[1]), PACKET_LOAD(o[2]), PACKET_LOAD(d[0]), PACKET_LOAD(d[1]),
                                  PACKET_LOAD(d[2]), PACKET_LOAD(own), PACKET_LOAD(end));
        lanes_trace(&rays, false, nodes, leaves, triangles, planes);
#pragma unroll 1
        for (int l = 0; l < PENCIL_WIDTH; ++l)
            if (chains[l].open)
                arrive_chain(chains + l, LANE_INT(rays.triangle, l), LANE_FLOAT(rays.nearest, l), &scene,
                             chains[l].on_film ? near_first : near_next, chains[l].on_film ? sky_first : sky_next);
    }
#pragma unroll 1
    for (int l = 0; l < PENCIL_WIDTH && begin + l < chain_count; ++l) {
        // The albedo of a vertex already holds what the chain carries.
        Vertex v = chains[l].at;
        float3 f = chains[l].t.factor;
        v.albedo =
            (float3)(f.x > 0.0f ? v.albedo.x / f.x : 0.0f, f.y > 0.0f ? v.albedo.y / f.y : 0.0f, f.z > 0.0f ? v.albedo.z / f.z : 0.0f);
        if (chains[l].negative) chains[l].t.factor = -f;
        if (shared) uneven[begin + l] = chains[l].uneven;
        store_vertex(surfels, capacity, first + begin + l, &v, chains[l].t);
    }
}

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH chains
/// in     : from[from_capacity]: surfels that chains start on; starts[chain_count]: which of them, where there is a list, else chain k starts on
///          surfel first + k; shared: so many chains one after the other start on the same, and all take a first step along the lobes, or, where they
///          have such a base, for what the base scatters otherwise than evenly; 0: each has a surfel of its own and may stop there; balanced: light samples on the lobes of that surfel leave their share to `shared` chains, else
///          to one;
///          viewers[first_viewer ..]: who sees these, `texels` of them each, or 0; near_first, near_next
///          [material]: of the light samples that reach the first vertex and the others (emit_hemispheres.cl); sky_first, sky_next: number of those
///          that are the sky's; the scene; seed
/// out    : surfels[capacity], from number `first` on: where chains end, with what they carry. May be the same buffer as `from`. uneven[chain]:
///          of chains of `shared`: what they count beside even light, where that is 0 in the mean
kernel void follow_surfels(global const float *from, int from_capacity, global const int *starts, int listed, int shared, int balanced,
                           int chain_count, global const SurfacePencil *viewers, int first_viewer, int texels,
                           global const float *near_first, global const float *near_next, float sky_first, float sky_next, uint seed,
                           HIERARCHY_PARAMETERS, SURFACES_PARAMETERS, global float *surfels, int capacity, int first,
                           global float *uneven) {
    int begin = get_global_id(0) * PENCIL_WIDTH;
    if (begin >= chain_count) return;
    follow_surfels_packet(begin, from, from_capacity, starts, listed, shared, balanced, chain_count, viewers, first_viewer, texels,
                          near_first, near_next, sky_first, sky_next, seed, nodes, leaves, SURFACES_ARGUMENTS, surfels, capacity, first,
                          uneven);
}
