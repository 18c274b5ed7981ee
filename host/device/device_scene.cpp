#include "device/device_scene.h"

namespace pencil {

DeviceScene::DeviceScene(const std::shared_ptr<Device>& device, const FlatScene& flat, const Bvh& bvh, const Clusters& grouped)
    : triangle_count(static_cast<int>(flat.triangles.size())),
      shape_count(flat.shape_count),
      cluster_count(grouped.count),
      has_bvh(!bvh.nodes.empty()),
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
      nodes(device, bvh.nodes, "hierarchy"),
      leaves(device, bvh.leaves, "leaves of the hierarchy"),
      clusters(device, grouped.boxes, "clusters of triangles"),
      members(device, grouped.members, "members of clusters") {}

}  // namespace pencil
