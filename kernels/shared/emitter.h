// One emitter that light paths choose: a triangle, or a point light.
#pragma once

#include "shared/types.h"

PENCIL_SHARED_BEGIN

typedef struct Emitter {
    float4 position;  // of a point light: xyz [scene units]
    float4 emission;  // of a point light: rgb radiant intensity, in scene units; w: share of all power up to and with this emitter
    //------------------------------------------------- 32 B
    int triangle;  // index into triangles, -1: a point light
    float chance;  // share of all power
    int unused_x;
    int unused_y;
    //------------------------------------------------- 48 B
} Emitter;
PENCIL_SHARED_TYPE(Emitter)

PENCIL_SHARED_END
