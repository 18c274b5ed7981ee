// Octahedral map, thesis eq. (4.25): the only place of this mathematics on the device. u, v are in [-1, 1]; texel (x, y) of a tile of
// n x n texels has its centre at u = (2 x + 1) / n - 1. Directions have unit L1 norm where they come out of the map.

#include "shared/atlas.h"

/// Direction of unit L1 norm through (u, v); inverse of eq. (4.25). Inside the diamond |u| + |v| <= 1 lies z >= 0.
static inline float4 oct_to_direction(float u, float v) {
    float z = 1.0f - fabs(u) - fabs(v);
    float fold = fmax(-z, 0.0f);
    return (float4)(u - copysign(fold, u), v - copysign(fold, v), z, 0.0f);
}

/// Folds texel coordinates that lie up to one texel outside the tile back into it: (-1, y) is (0, n-1-y), and so on for all four sides;
/// a corner goes to the diagonally opposite corner.
static inline int2 oct_fold_texel(int2 texel, int n) {
    if (texel.x < 0 || texel.x >= n) texel = (int2)(texel.x < 0 ? -1 - texel.x : 2 * n - 1 - texel.x, n - 1 - texel.y);
    if (texel.y < 0 || texel.y >= n) texel = (int2)(n - 1 - texel.x, texel.y < 0 ? -1 - texel.y : 2 * n - 1 - texel.y);
    return texel;
}

/// The same of texel + step.
static inline int2 oct_texel_beside(int2 texel, int2 step, int n) { return oct_fold_texel(texel + step, n); }

/// Texel `x` of row `row`.
static inline int2 oct_texel_of_row(int x, int row, int n) { return (int2)(x, row); }

/// True if a texel lies in the tile with all that are next to it; if a footprint may start there: not in the last gutter column or row.
static inline bool oct_is_inner(int2 texel, int n) { return min(texel.x, texel.y) > 0 && max(texel.x, texel.y) < n - 1; }
static inline bool oct_starts_footprint(int2 texel, int n) { return texel.x < n && texel.y < n; }

/// Direction of unit L1 norm through the centre of a texel.
static inline float4 oct_texel_direction(int2 texel, int n) {
    return oct_to_direction((2 * texel.x + 1) / (float)n - 1.0f, (2 * texel.y + 1) / (float)n - 1.0f);
}

/// Texel whose centre lies in the opposite direction: |u'| = 1 - |v|, |v'| = 1 - |u|, signs turned.
static inline int2 oct_antipode(int2 texel, int n) {
    int half_n = n / 2;
    // Ring index of the mirrored quadrant, 0 next to the axis: |u| = (2 k + 1) / n.
    int kx = texel.x >= half_n ? texel.x - half_n : half_n - 1 - texel.x;
    int ky = texel.y >= half_n ? texel.y - half_n : half_n - 1 - texel.y;
    int ax = half_n - 1 - ky;
    int ay = half_n - 1 - kx;
    return (int2)(texel.x >= half_n ? half_n - 1 - ax : half_n + ax, texel.y >= half_n ? half_n - 1 - ay : half_n + ay);
}

/// Solid angle of a texel from its direction of unit L1 norm: du dv / |d|^3 (Jacobian of the octahedral map), texel area (2/n)^2.
static inline float oct_texel_solid_angle(int2 texel, int n) {
    float4 direction = oct_texel_direction(texel, n);
    float inverse = rsqrt(dot(direction.xyz, direction.xyz));
    return 4.0f / ((float)n * n) * inverse * inverse * inverse;
}

/// Orders of texels, so that packets of 8 or 16, and blocks of packets, see neighbouring things [texels].
#define SURFEL_BLOCK 8  // side of a block of surfels
#define PATCH_WIDTH 4   // in it
#define PATCH_HEIGHT 2
#define RAY_BLOCK 4  // side of a block of rays

/// Texel of surfel `i` of a tile. Surfels run through a tile in blocks of SURFEL_BLOCK^2 texels, and in a block in patches. n is a multiple
/// of SURFEL_BLOCK.
static inline int2 oct_surfel_texel(int i, int n) {
    const int in_block = SURFEL_BLOCK * SURFEL_BLOCK, in_patch = PATCH_WIDTH * PATCH_HEIGHT, across = SURFEL_BLOCK / PATCH_WIDTH;
    int block = i / in_block, patch = i % in_block / in_patch, lane = i % in_patch;
    int2 corner = SURFEL_BLOCK * (int2)(block % (n / SURFEL_BLOCK), block / (n / SURFEL_BLOCK));
    return corner + (int2)(patch % across * PATCH_WIDTH + lane % PATCH_WIDTH, patch / across * PATCH_HEIGHT + lane / PATCH_WIDTH);
}

/// Texel `i` of a tile in an order by blocks of RAY_BLOCK^2 texels, for packets that must be compact. n is a multiple of RAY_BLOCK.
static inline int2 oct_block_texel(int i, int n) {
    int block = i / (RAY_BLOCK * RAY_BLOCK), lane = i % (RAY_BLOCK * RAY_BLOCK);
    return RAY_BLOCK * (int2)(block % (n / RAY_BLOCK), block / (n / RAY_BLOCK)) + (int2)(lane % RAY_BLOCK, lane / RAY_BLOCK);
}

/// Index of a texel (or of a gutter texel, coordinates -1 and n) in the atlas buffer.
static inline int oct_atlas_index(int tile, int2 texel, int n) {
    return tile * PENCIL_TILE_TEXELS(n) + (texel.y + PENCIL_GUTTER) * PENCIL_TILE_STRIDE(n) + texel.x + PENCIL_GUTTER;
}
