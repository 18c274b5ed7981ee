// One point sample of the emitters, thesis alg. 6.2: l_i, n_i and E_i.
#pragma once

#include "shared/types.h"

PENCIL_SHARED_BEGIN

// Surfels that draw light samples together: as many whatever the width of packets, so that results do not depend on it.
#define LIGHT_SURFELS 16

// LightSample.position.w
#define LIGHT_POINT 0.0f
#define LIGHT_AREA 1.0f
#define LIGHT_INFINITE 2.0f
#define LIGHT_SPOT 3.0f
#define LIGHT_PROFILE 4.0f

// Tables of intensity by direction: angles to the axis from 0 to 180 degrees, for azimuths from 0 on.
#define PROFILE_ROWS 181
#define PROFILE_COLUMNS 72

typedef struct LightSample {
    float4 position;  // xyz: place [scene units], of infinitely far light the unit direction in which it travels; w: LIGHT_...
    float4
        normal;  // xyz: unit normal of the emitting side, axis of a spot or profile, else 0; w: area of the emitter it stands for / pi [scene
                 // units^2], of infinitely far light the solid angle it stands for [sr]
    float4
        emission;  // rgb: radiance times that area (area emitter), radiant intensity (point light, on the axis of a spot), in scene units, or
        // irradiance (infinitely far); w: plane of the emitter as a float, or -1; of a spot: angle where it ends [radian], of a profile: first
        // texel of its table
    //------------------------------------------------- 48 B
} LightSample;
PENCIL_SHARED_TYPE(LightSample)

PENCIL_SHARED_END
