#include "line/placement/trace_probing_rays.h"

#include <cstring>

#include "device/surfels.h"

namespace pencil {

std::vector<ProbingHit> trace_probing_rays(Kernels& kernels, const DeviceScene& scene, const std::vector<ProbingRay>& rays) {
    if (rays.empty()) return {};
    std::vector<float4> starts, ways;
    std::vector<int> planes;
    for (const ProbingRay& ray : rays) {
        starts.emplace_back(glm::vec3(ray.origin), 0.0F);
        ways.emplace_back(glm::vec3(ray.direction), 0.0F);
        planes.push_back(ray.plane);
    }
    const int count = static_cast<int>(rays.size());
    const Buffer<float4> origins(kernels.device(), starts, "origins of probing rays"),
        directions(kernels.device(), ways, "directions of probing rays");
    const Buffer<int> own(kernels.device(), planes, "planes of probing rays");
    Surfels surfels(kernels, count, "surfels of probing rays");
    Buffer<float> distances(kernels.device(), rays.size(), "distances of probing rays");
    kernels.get("trace_probing_rays")
        .args(origins, directions, own, count, scene.nodes, scene.leaves, scene.triangles, scene.planes, scene.materials, scene.normals,
              surfels.data, surfels.capacity, distances)
        .run(rays.size(), "trace probing rays");

    const std::vector<float> fields = surfels.data.read(), reached = distances.read();
    const auto vector = [&](int field, std::size_t i) {
        const auto at = [&](int f) { return static_cast<double>(fields[static_cast<std::size_t>(f * surfels.capacity) + i]); };
        return glm::dvec3(at(field), at(field + 1), at(field + 2));
    };
    const auto plane_of = [&](std::size_t i) {
        int plane = 0;
        std::memcpy(&plane, &fields[static_cast<std::size_t>(SURFEL_PLANE * surfels.capacity) + i], sizeof plane);
        return plane;
    };
    std::vector<ProbingHit> hits;
    for (std::size_t i = 0; i < rays.size(); ++i)
        hits.push_back(
            {vector(SURFEL_X, i), vector(SURFEL_GX, i), vector(SURFEL_ALBEDO_R, i), static_cast<double>(reached[i]), plane_of(i)});
    return hits;
}

}  // namespace pencil
