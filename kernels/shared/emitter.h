// One emitter that light paths choose: a triangle, a point light or spot, parallel light, or a texel of the sky.
#pragma once

#include "shared/types.h"

// Emitter.triangle of what is none.
#define EMITTER_POINT (-1)
#define EMITTER_PARALLEL (-2)
#define EMITTER_SKY (-3)

PENCIL_SHARED_BEGIN

typedef struct Emitter {
    float4 position;  // of a point light: xyz [scene units]; of a spot w: angle where it ends [radian], of a profile
                      // -1 - first texel of its table, else 0
    float4
        emission;  // of a point light: rgb radiant intensity, in scene units; of parallel light irradiance; w: share of all power up to and
                   // with this emitter
    float4 axis;   // of a spot: xyz, w: angle of its beam [radian]; of parallel light: direction in which it travels
    //------------------------------------------------- 48 B
    int triangle;  // index into triangles, or EMITTER_...
    float chance;  // of being chosen
    int column;    // of a texel of the sky
    int row;
    //------------------------------------------------- 64 B
} Emitter;
PENCIL_SHARED_TYPE(Emitter)

PENCIL_SHARED_END
