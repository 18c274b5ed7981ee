// The flattened scene in device memory.
#pragma once

#include <cstddef>
#include <tuple>
#include <variant>

#include "cl/buffer.h"
#include "pencils/build_bvh.h"
#include "pencils/build_wide_bvh.h"
#include "pencils/cluster_triangles.h"
#include "pencils/flat_scene.h"

namespace pencil {

/// What has been prepared beside the triangles.
struct Prepared {
    bool clusters = false, bvh = false;
};

/// Of the form that the kernels are built for (Features::wide_bvh).
using Hierarchy = std::variant<Bvh, WideBvh>;
Hierarchy build_hierarchy(const FlatScene& flat, bool wide);

struct DeviceScene {
    /// `bvh`: empty where no kernel follows rays; `grouped`: empty where none rasterises by clusters.
    DeviceScene(const std::shared_ptr<Device>& device, const FlatScene& flat, const Hierarchy& bvh = {}, const Clusters& grouped = {});

    /// Arguments of kernels: `triangles, planes`; with `materials, normals, uvs, textures, texels` behind them; `sky,
    /// sky_texels`; `triangles, triangle_count, planes`; `nodes, leaves`.
    auto faces() const { return std::tie(triangles, planes); }
    auto surfaces() const { return std::tie(triangles, planes, materials, normals, uvs, textures, texels); }
    auto environment() const { return std::tie(sky, sky_texels); }
    auto all_triangles() const { return std::tie(triangles, triangle_count, planes); }
    auto hierarchy() const { return std::tie(nodes, leaves); }

    /// Follows the scene's camera.
    void look(const FlatScene& flat) { to_film.write(flat.to_film); }

    Prepared prepared() const { return {cluster_count > 0, has_bvh}; }

    int triangle_count, shape_count, cluster_count;
    bool has_bvh;
    Buffer<Triangle> triangles;
    Buffer<float4> planes;
    Buffer<Material> materials;
    Buffer<float4> normals;  // empty unless Features::smooth
    Buffer<glm::vec2> uvs;   // empty unless Features::textures, as are the next two
    Buffer<TextureRow> textures;
    Buffer<std::uint64_t> texels;
    Buffer<Sky> sky;  // with its texels empty unless Features::sky
    Buffer<float4> sky_texels;
    Buffer<float4> to_film;
    Buffer<std::byte> nodes, leaves;  // of the hierarchy, in either form
    Buffer<Cluster> clusters;
    Buffer<int> members;
};

}  // namespace pencil
