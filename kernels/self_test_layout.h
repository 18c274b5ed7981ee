// Sizes and offsets of the structs that host and device share, as one list for both: SIZE(type) and FIELD(type, member).
#pragma once

#include "shared/camera.h"
#include "shared/geometry.h"
#include "shared/light.h"

// clang-format off
#define PENCIL_LAYOUT(SIZE, FIELD)                                                                                                  \
    SIZE(float4)                                                                                                                    \
    SIZE(Triangle)                                                                                                                  \
    FIELD(Triangle, v0) FIELD(Triangle, v1) FIELD(Triangle, v2)                                                                     \
    FIELD(Triangle, plane) FIELD(Triangle, material) FIELD(Triangle, shape) FIELD(Triangle, mates)                                   \
    SIZE(Material)                                                                                                                  \
    FIELD(Material, albedo) FIELD(Material, emission)                                                                               \
    SIZE(Hit)                                                                                                                       \
    FIELD(Hit, triangle) FIELD(Hit, disparity)                                                                                      \
    SIZE(LightSample)                                                                                                               \
    FIELD(LightSample, position) FIELD(LightSample, normal) FIELD(LightSample, emission)                                            \
    SIZE(Camera)                                                                                                                    \
    FIELD(Camera, origin) FIELD(Camera, corner) FIELD(Camera, step_x) FIELD(Camera, step_y)                                         \
    FIELD(Camera, width) FIELD(Camera, height) FIELD(Camera, near_clip) FIELD(Camera, far_clip)
// clang-format on
