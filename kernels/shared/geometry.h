// Scene geometry as the kernels see it, in normalised scene units: the scene is recentred in double precision and scaled by a power
// of two until its largest extent is in (1, 2], so rounding errors have one known size whatever the scene's own units are.
#pragma once

#include "shared/types.h"

// The two counts in Triangle.mates.
#define MATES_BEFORE(mates) ((mates)&0xff)
#define MATES_AFTER(mates) ((mates) >> 8)

PENCIL_SHARED_BEGIN

typedef struct Triangle {
    float4 v0;  // xyz: corner [scene units]; w: unused
    float4 v1;
    float4 v2;
    //------------------------------------------------- 48 B
    int plane;     // index into planes; coplanar neighbours of one shape share it
    int material;  // index into materials
    int shape;     // index of the shape in the scene, for layers and messages
    int mates;     // triangles of the same plane just before it in the list (bits 0-7) and just after it (bits 8-15), few of each
    //------------------------------------------------- 64 B
} Triangle;

// What a ray through a texel or pixel meets first. "Disparity" is the reciprocal of the ray parameter t of the hit, for a direction of
// unit L1 norm (octahedral tiles) or for the camera's own direction (film). Disparity is affine in the texel coordinates on a plane.
typedef struct Hit {
    int triangle;     // index into triangles, -1 if nothing is met
    float disparity;  // 1/t > 0, 0 if nothing is met
} Hit;

PENCIL_SHARED_END
