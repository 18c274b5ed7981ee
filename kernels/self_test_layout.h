// Sizes and offsets of the structs that host and device share, as one list for both: SIZE(type) and FIELD(type, member). Every
// struct of kernels/shared is in it (test_layout.cpp).
#pragma once

#include "shared/bvh.h"
#include "shared/camera.h"
#include "shared/cluster.h"
#include "shared/emitter.h"
#include "shared/geometry.h"
#include "shared/light.h"
#include "shared/material.h"
#include "shared/surface_pencil.h"

// clang-format off
#define PENCIL_LAYOUT(SIZE, FIELD)                                                                                                  \
    SIZE(float4)                                                                                                                    \
    SIZE(Triangle)                                                                                                                  \
    FIELD(Triangle, v0) FIELD(Triangle, v1) FIELD(Triangle, v2)                                                                     \
    FIELD(Triangle, plane) FIELD(Triangle, material) FIELD(Triangle, shape) FIELD(Triangle, mates)                                  \
    SIZE(Material)                                                                                                                  \
    FIELD(Material, albedo) FIELD(Material, emission) FIELD(Material, model)                                                        \
    SIZE(Hit)                                                                                                                       \
    FIELD(Hit, triangle) FIELD(Hit, disparity)                                                                                      \
    SIZE(LightSample)                                                                                                               \
    FIELD(LightSample, position) FIELD(LightSample, normal) FIELD(LightSample, emission)                                            \
    SIZE(Emitter)                                                                                                                   \
    FIELD(Emitter, position) FIELD(Emitter, emission) FIELD(Emitter, triangle) FIELD(Emitter, chance)                               \
    SIZE(Camera)                                                                                                                    \
    FIELD(Camera, origin) FIELD(Camera, corner) FIELD(Camera, step_x) FIELD(Camera, step_y)                                         \
    FIELD(Camera, width) FIELD(Camera, height) FIELD(Camera, near_clip) FIELD(Camera, far_clip)                                     \
    SIZE(BvhNode)                                                                                                                   \
    FIELD(BvhNode, low) FIELD(BvhNode, high) FIELD(BvhNode, child) FIELD(BvhNode, count)                                            \
    SIZE(Cluster)                                                                                                                   \
    FIELD(Cluster, low) FIELD(Cluster, high)                                                                                        \
    SIZE(SurfacePencil)                                                                                                             \
    FIELD(SurfacePencil, position) FIELD(SurfacePencil, normal) FIELD(SurfacePencil, facing)                                        \
    FIELD(SurfacePencil, horizon_x) FIELD(SurfacePencil, horizon_y)                                                                 \
    FIELD(SurfacePencil, plane) FIELD(SurfacePencil, key) FIELD(SurfacePencil, spacing)                                             \
    SIZE(PencilGrid)                                                                                                                \
    FIELD(PencilGrid, origin) FIELD(PencilGrid, levels) FIELD(PencilGrid, slots) FIELD(PencilGrid, count)
// clang-format on
