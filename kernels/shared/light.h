// One point sample of the emitters, thesis alg. 6.2: l_i, n_i and E_i.
#pragma once

#include "shared/types.h"

PENCIL_SHARED_BEGIN

typedef struct LightSample {
    float4 position;  // xyz [scene units]; w: 1 for a sample of an area emitter, 0 for a point light
    float4 normal;    // xyz: unit normal of the emitting side (zero for a point light); w: area of the emitter it stands for / pi [scene
                      // units^2]
    float4 emission;  // rgb: radiance times that area (area emitter) or radiant intensity (point light), in scene units; w: plane of the
                      // emitter as a float, or -1
    //------------------------------------------------- 48 B
} LightSample;

PENCIL_SHARED_END
