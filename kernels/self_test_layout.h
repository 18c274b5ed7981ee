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
#include "shared/sky.h"
#include "shared/surface_pencil.h"
#include "shared/texture.h"

// clang-format off
#define PENCIL_LAYOUT(SIZE, FIELD)                                                                                                  \
    SIZE(float4)                                                                                                                    \
    SIZE(Triangle)                                                                                                                  \
    FIELD(Triangle, v0) FIELD(Triangle, v1) FIELD(Triangle, v2)                                                                     \
    FIELD(Triangle, plane) FIELD(Triangle, material) FIELD(Triangle, shape) FIELD(Triangle, mates)                                  \
    SIZE(Material)                                                                                                                  \
    FIELD(Material, albedo) FIELD(Material, emission) FIELD(Material, model) FIELD(Material, parameters)                            \
    FIELD(Material, specular) FIELD(Material, transmitted) FIELD(Material, eta) FIELD(Material, k) FIELD(Material, flags)           \
    FIELD(Material, back) FIELD(Material, first) FIELD(Material, second) FIELD(Material, weight)                                    \
    FIELD(Material, albedo_texture) FIELD(Material, specular_texture) FIELD(Material, alpha_texture)                                \
    FIELD(Material, weight_texture) FIELD(Material, normal_texture) FIELD(Material, emission_texture)                               \
    FIELD(Material, metallic_texture) FIELD(Material, gloss) FIELD(Material, varnish) FIELD(Material, glow)                                               \
    SIZE(TextureRow)                                                                                                                \
    FIELD(TextureRow, row_u) FIELD(TextureRow, row_v) FIELD(TextureRow, colour) FIELD(TextureRow, kind)                             \
    FIELD(TextureRow, first) FIELD(TextureRow, width) FIELD(TextureRow, height) FIELD(TextureRow, wrap_u)                           \
    FIELD(TextureRow, wrap_v) FIELD(TextureRow, nearest)                                                                            \
    SIZE(Sky)                                                                                                                       \
    FIELD(Sky, to_local) FIELD(Sky, width) FIELD(Sky, height) FIELD(Sky, limit) FIELD(Sky, each_sample)                             \
    SIZE(Hit)                                                                                                                       \
    FIELD(Hit, triangle) FIELD(Hit, disparity)                                                                                      \
    SIZE(LightSample)                                                                                                               \
    FIELD(LightSample, position) FIELD(LightSample, normal) FIELD(LightSample, emission)                                            \
    SIZE(Emitter)                                                                                                                   \
    FIELD(Emitter, position) FIELD(Emitter, emission) FIELD(Emitter, axis) FIELD(Emitter, triangle)                                 \
    FIELD(Emitter, chance) FIELD(Emitter, column) FIELD(Emitter, row)                                                               \
    SIZE(Camera)                                                                                                                    \
    FIELD(Camera, origin) FIELD(Camera, corner) FIELD(Camera, step_x) FIELD(Camera, step_y)                                         \
    FIELD(Camera, shift_x) FIELD(Camera, shift_y) FIELD(Camera, lens_x) FIELD(Camera, lens_y)                                       \
    FIELD(Camera, width) FIELD(Camera, height) FIELD(Camera, near_clip) FIELD(Camera, far_clip)                                     \
    SIZE(BvhNode)                                                                                                                   \
    FIELD(BvhNode, low) FIELD(BvhNode, high) FIELD(BvhNode, child) FIELD(BvhNode, count)                                            \
    SIZE(WideNode)                                                                                                                  \
    FIELD(WideNode, low) FIELD(WideNode, high) FIELD(WideNode, child)                                                               \
    SIZE(WideLeaf)                                                                                                                  \
    FIELD(WideLeaf, corner) FIELD(WideLeaf, plane) FIELD(WideLeaf, plane_index) FIELD(WideLeaf, triangle)                           \
    SIZE(Cluster)                                                                                                                   \
    FIELD(Cluster, low) FIELD(Cluster, high)                                                                                        \
    SIZE(SurfacePencil)                                                                                                             \
    FIELD(SurfacePencil, position) FIELD(SurfacePencil, normal) FIELD(SurfacePencil, facing)                                        \
    FIELD(SurfacePencil, horizon_x) FIELD(SurfacePencil, horizon_y)                                                                 \
    FIELD(SurfacePencil, plane) FIELD(SurfacePencil, key) FIELD(SurfacePencil, spacing)                                             \
    SIZE(PencilGrid)                                                                                                                \
    FIELD(PencilGrid, origin) FIELD(PencilGrid, levels) FIELD(PencilGrid, slots) FIELD(PencilGrid, count)
// clang-format on
