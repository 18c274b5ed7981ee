// The experiment of thesis 6.3.1: every surfel looks up the maps of all pencils. Written once; PENCIL_MAP names the parameterisation, whose
// functions begin with it.

#include "lib/cube.cl"
#include "lib/footprint.cl"
#include "lib/octahedral.cl"
#include "lib/packet.cl"
#include "lib/panels.cl"
#include "lib/paraboloid.cl"
#include "lib/pyramid.cl"
#include "lib/surfel_packet.cl"
#ifdef PENCIL_SUPERQUADRIC_EXPONENT
#include "lib/superquadric.cl"
#endif

#define MAP_JOIN2(a, b) a##b
#define MAP_JOIN(a, b) MAP_JOIN2(a, b)
#define MAP(name) MAP_JOIN(PENCIL_MAP, name)

/// The octahedral map under the name that the other maps' functions have.
static inline Footprint octahedral_footprint(vfloat vx, vfloat vy, vfloat vz, int n) { return packet_footprint(vx, vy, vz, n); }

/// Radiance (rgb) and distance (w) by bilinear interpolation.
static inline float4 fetch_bilinear(global const float4 *texels, int index, int stride, float fx, float fy) {
    global const float4 *t = texels + index;
    float4 upper = t[0] + fx * (t[1] - t[0]);
    float4 lower = t[stride] + fx * (t[stride + 1] - t[stride]);
    return upper + fy * (lower - upper);
}

/// A surfel is seen if it is not farther than this times its distance in the map: well apart from the error of interpolated distances.
#define LOOK_UP_SLACK 1.05f

/// launch : 1-D, one work-item per block of PENCIL_BLOCK packets of PENCIL_WIDTH surfels
/// in     : surfels of `capacity`; cops[pencil_count]; texels: `tiles` tiles of n x n per pencil, rgb radiance, w distance; gutters filled
/// out    : sums[3][capacity]: radiance of the pencils that each surfel sees, summed. With LOOK_UP_FETCH 0 no texel is read: the sums are
///          of the footprints' places, which leaves the arithmetic of the map alone.
kernel void look_up_maps(global const float *surfels, int capacity, int surfel_count, global const float4 *cops, int pencil_count,
                         global const float4 *texels, int tiles, int n, global float *sums) {
    int first = get_global_id(0) * PENCIL_BLOCK * PENCIL_WIDTH, stride = PENCIL_TILE_STRIDE(n);
    if (first >= surfel_count) return;
    SurfelPacket packets[PENCIL_BLOCK];
    vfloat places[PENCIL_BLOCK];
    float4 light[PENCIL_BLOCK * PENCIL_WIDTH];
    for (int p = 0; p < PENCIL_BLOCK; ++p) {
        packets[p] = load_surfels(surfels, capacity, first + p * PENCIL_WIDTH);
        places[p] = 0.0f;
        for (int l = 0; l < PENCIL_WIDTH; ++l) light[p * PENCIL_WIDTH + l] = (float4)(0.0f);
    }
    for (int i = 0; i < pencil_count; ++i) {
        float4 cop = cops[i];
        int tile = i * tiles * PENCIL_TILE_TEXELS(n);
        for (int p = 0; p < PENCIL_BLOCK; ++p) {
            vfloat vx = packets[p].x - cop.x, vy = packets[p].y - cop.y, vz = packets[p].z - cop.z;
            Footprint f = MAP(_footprint)(vx, vy, vz, n);
            if (!LOOK_UP_FETCH) {
                places[p] += PACKET_TO_FLOAT(f.index) + f.fx + f.fy;
                continue;
            }
            vfloat distance = sqrt(fma(vx, vx, fma(vy, vy, vz * vz)));
            vint index = f.index + tile;
#pragma unroll
            for (int l = 0; l < PENCIL_WIDTH; ++l) {
                float4 texel = fetch_bilinear(texels, LANE_INT(index, l), stride, LANE_FLOAT(f.fx, l), LANE_FLOAT(f.fy, l));
                light[p * PENCIL_WIDTH + l] += LANE_FLOAT(distance, l) <= LOOK_UP_SLACK * texel.w ? texel : (float4)(0.0f);
            }
        }
    }
    for (int p = 0; p < PENCIL_BLOCK; ++p) {
        float r[PENCIL_WIDTH], g[PENCIL_WIDTH], b[PENCIL_WIDTH];
        for (int l = 0; l < PENCIL_WIDTH; ++l) {
            r[l] = LOOK_UP_FETCH ? light[p * PENCIL_WIDTH + l].x : LANE_FLOAT(places[p], l);
            g[l] = light[p * PENCIL_WIDTH + l].y;
            b[l] = light[p * PENCIL_WIDTH + l].z;
        }
        store_rgb(sums, capacity, first + p * PENCIL_WIDTH, PACKET_LOAD(r), PACKET_LOAD(g), PACKET_LOAD(b), 0);
    }
}
