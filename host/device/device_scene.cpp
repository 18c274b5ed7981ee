#include "device/device_scene.h"

namespace pencil {

namespace {

template <typename T>
Buffer<std::byte> bytes_of(const std::shared_ptr<Device>& device, const std::vector<T>& data, const std::string& what) {
    Buffer<std::byte> bytes(device, data.size() * sizeof(T), what);
    bytes.write_raw(data.data());
    return bytes;
}

}  // namespace

Hierarchy build_hierarchy(const FlatScene& flat, bool wide) {
    if (wide) return build_wide_bvh(flat.triangles, flat.planes);
    return build_bvh(flat.triangles);
}

DeviceScene::DeviceScene(const std::shared_ptr<Device>& device, const FlatScene& flat, const Hierarchy& bvh, const Clusters& grouped)
    : triangle_count(static_cast<int>(flat.triangles.size())),
      shape_count(flat.shape_count),
      cluster_count(grouped.count),
      has_bvh(std::visit([](const auto& form) { return !form.nodes.empty(); }, bvh)),
      triangles(device, flat.triangles, "triangles"),
      planes(device, flat.planes, "planes"),
      materials(device, flat.materials, "materials"),
      normals(device, flat.normals, "vertex normals"),
      uvs(device, flat.uvs, "texture coordinates"),
      textures(device, flat.textures, "textures"),
      texels(device, flat.texels, "texels of textures"),
      sky(device, std::vector<Sky>{flat.sky}, "environment"),
      sky_texels(device, flat.sky_texels, "texels of the environment"),
      to_film(device, flat.to_film, "film projection"),
      nodes(std::visit([&](const auto& form) { return bytes_of(device, form.nodes, "hierarchy"); }, bvh)),
      leaves(std::visit([&](const auto& form) { return bytes_of(device, form.leaves, "leaves of the hierarchy"); }, bvh)),
      clusters(device, grouped.boxes, "clusters of triangles"),
      members(device, grouped.members, "members of clusters") {}

}  // namespace pencil
