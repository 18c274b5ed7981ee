// The ray of the continuous pixel position (px, py), y down, is origin + t * (corner + px * step_x + py * step_y), t > 0. Other cameras than
// pinholes move its origin and turn it (lib/camera_ray.cl).
#pragma once

#include "shared/types.h"

PENCIL_SHARED_BEGIN

typedef struct Camera {
    float4 origin;  // xyz [scene units]; w unused in all four
    float4 corner;  // direction through the film's upper left corner, one unit in front of the pinhole
    float4 step_x;  // change of direction per pixel to the right
    float4 step_y;  // change of direction per pixel down
    //------------------------------------------------- 64 B
    // Of a thin lens or an orthographic camera (PENCIL_WIDE_CAMERA), else 0:
    float4 shift_x;  // change of origin per pixel to the right [scene units]
    float4 shift_y;  // and down
    float4 lens_x;   // half axes of the lens [scene units]; w: 1 / depth of what is sharp
    float4 lens_y;
    //------------------------------------------------- 128 B
    int width;  // film size [pixels]
    int height;
    float near_clip;  // smallest t that is seen (t is the depth along the optical axis), 0 if none
    float far_clip;   // largest t that is seen, INFINITY if none
    //------------------------------------------------- 144 B
} Camera;
PENCIL_SHARED_TYPE(Camera)

PENCIL_SHARED_END
