// Textures: what a surface's colour is at (u, v). Texels of all bitmaps, and the colours of vertices, lie one behind the other in one buffer,
// as four half floats each.
#pragma once

#include "shared/types.h"

#define TEXTURE_BITMAP 0
#define TEXTURE_CHECKERBOARD 1
#define TEXTURE_VERTEX_COLOURS 2

#define TEXTURE_REPEAT 0
#define TEXTURE_MIRROR 1
#define TEXTURE_CLAMP 2

PENCIL_SHARED_BEGIN

typedef struct TextureRow {
    float4 row_u;      // u' = dot(row_u.xyz, (u, v, 1))
    float4 row_v;      // v' likewise
    float4 colour[2];  // of a checkerboard
    //------------------------------------------------- 64 B
    int kind;   // TEXTURE_...
    int first;  // texel: of a bitmap row by row, of vertex colours three per triangle
    int width;  // of a bitmap [texels]
    int height;
    int wrap_u;  // TEXTURE_...
    int wrap_v;
    int nearest;  // 1: no bilinear filter
    int unused;
    //------------------------------------------------- 96 B
} TextureRow;
PENCIL_SHARED_TYPE(TextureRow)

PENCIL_SHARED_END
