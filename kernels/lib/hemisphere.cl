// The map of a surface pencil: n x n texels over the hemisphere about a normal, of equal cosine-weighted solid angle pi / n^2, by the
// concentric map of square to disc (Shirley and Chiu 1997) and Malley's projection of the disc. DEVIATION: not octahedral: an octahedral
// map would spend half of its texels below the surface and most of the others where the cosine is small. Each texel is seen through one
// point of it, random for each key and shifted from turn to turn: sums over texels are unbiased. n is a multiple of 4.

#include "lib/packet.cl"

/// Entries of a map run through blocks of texels of this side, so that packets see neighbouring things.
#define HEMISPHERE_BLOCK 4

/// Texel of map entry `i`.
static inline int2 hemisphere_texel(int i, int n) {
    int block = i / (HEMISPHERE_BLOCK * HEMISPHERE_BLOCK), lane = i % (HEMISPHERE_BLOCK * HEMISPHERE_BLOCK), blocks = n / HEMISPHERE_BLOCK;
    return HEMISPHERE_BLOCK * (int2)(block % blocks, block / blocks) + (int2)(lane % HEMISPHERE_BLOCK, lane / HEMISPHERE_BLOCK);
}

/// Point of the unit disc for a point of the square [-1, 1]^2.
static inline void concentric_disc(vfloat a, vfloat b, vfloat *x, vfloat *y) {
    vint wide = PACKET_MASK(fabs(a) > fabs(b));
    vfloat radius = select(b, a, wide), other = select(a, b, wide);
    vfloat angle = select(other / radius, (vfloat)(0.0f), PACKET_MASK(radius == 0.0f)) * (0.25f * M_PI_F);
    vfloat s = sin(angle), c = cos(angle);
    *x = radius * select(s, c, wide);
    *y = radius * select(c, s, wide);
}

/// Tangents of a unit normal, without a branch that jumps (Duff et al. 2017).
static inline void tangent_frame(float3 n, float3 *t, float3 *b) {
    float s = copysign(1.0f, n.z);
    float k = -1.0f / (s + n.z);
    float m = n.x * n.y * k;
    *t = (float3)(1.0f + s * n.x * n.x * k, s * m, -s * n.x);
    *b = (float3)(m, s + n.y * n.y * k, -n.y);
}

/// Tangents of a unit normal, the first of them under unit direction o if that lies aside of the normal: the frame of bsdf.cl.
static inline void frame_towards(float3 n, float3 o, float3 *t, float3 *b) {
    float3 across = o - dot(n, o) * n;
    float width = length(across);
    if (!(width > 1e-6f)) {
        tangent_frame(n, t, b);
        return;
    }
    *t = across / width;
    *b = cross(n, *t);
}

/// Sector of azimuth of (x, y), 0 .. RING_SECTORS - 1.
static inline int ring_sector(float x, float y) { return (x < 0.0f ? 4 : 0) | (y < 0.0f ? 2 : 0) | (fabs(x) < fabs(y) ? 1 : 0); }
