// The flattened scene in device memory.
#pragma once

#include "cl/buffer.h"
#include "pencils/build_bvh.h"
#include "pencils/flat_scene.h"

namespace pencil {

struct DeviceScene {
    /// `bvh`: empty where no kernel follows rays.
    DeviceScene(const std::shared_ptr<Device>& device, const FlatScene& flat, const Bvh& bvh = {});

    int triangle_count;
    Buffer<Triangle> triangles;
    Buffer<float4> planes;
    Buffer<Material> materials;
    Buffer<float4> normals;  // empty unless Features::smooth
    Buffer<float4> to_film;
    Buffer<BvhNode> nodes;
    Buffer<int> leaves;
};

}  // namespace pencil
