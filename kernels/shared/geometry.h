// Scene geometry as the kernels see it, in normalised scene units: the scene is recentred in double precision, on the eye or the
// point of the scene that is nearest to it, and scaled by a power of two until its largest extent is in (1, 2]. Rounding errors are in
// proportion to coordinates, so they are small where things are seen from near (POSITION_ERROR).
#pragma once

#include "shared/types.h"

// The two counts in Triangle.mates.
#define MATES_BEFORE(mates) ((mates)&0xff)
#define MATES_AFTER(mates) ((mates) >> 8)

// Rounding of positions and of what is computed from them, in terms of the largest coordinate: some rounding errors of a float.
#define POSITION_ERROR 1e-6f

PENCIL_SHARED_BEGIN

typedef struct Triangle {
    float4 v0;  // xyz: corner [scene units]; w: unused
    float4 v1;
    float4 v2;
    //------------------------------------------------- 48 B
    int plane;     // index into planes; coplanar neighbours of one shape and material share it
    int material;  // index into materials
    int shape;     // index of the shape in the scene, for layers and messages
    int mates;     // triangles of the same plane just before it in the list (bits 0-7) and just after it (bits 8-15), few of each
    //------------------------------------------------- 64 B
} Triangle;
PENCIL_SHARED_TYPE(Triangle)

// What a ray through a texel or pixel meets first. "Disparity" is the reciprocal of the ray parameter t of the hit, for a direction of
// unit L1 norm (octahedral tiles) or for the camera's own direction (film). Disparity is affine in the texel coordinates on a plane.
typedef struct Hit {
    int triangle;     // index into triangles, -1 if nothing is met
    float disparity;  // 1/t > 0, 0 if nothing is met
} Hit;
PENCIL_SHARED_TYPE(Hit)

PENCIL_SHARED_END
