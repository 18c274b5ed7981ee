// Light from infinitely far away, all around: a map of texels of equal steps of longitude and latitude, or a constant (one texel). Each texel is
// split: what exceeds a limit is sampled as lights, the rest is seen by rays.
#pragma once

#include "shared/types.h"

PENCIL_SHARED_BEGIN

typedef struct Sky {
    float4 to_local[3];  // rows: world direction to the map's own frame, +y up
    //------------------------------------------------- 48 B
    int width;  // texels of map; 0: there is no environment
    int height;
    float limit;        // luminance above which a texel is split [W m^-2 sr^-1]
    float each_sample;  // density of a light sample per solid angle [1/sr] for each unit of luminance above the limit
    //------------------------------------------------- 64 B
} Sky;
PENCIL_SHARED_TYPE(Sky)

PENCIL_SHARED_END
