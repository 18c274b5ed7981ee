// The scene as rays see it: triangles in a unit-sized box, Embree's BVH over them, and what a hit point needs.
#pragma once

#include <embree3/rtcore.h>

#include <glm/glm.hpp>
#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

#include "reference/surface_table.h"
#include "scene/scene.h"

namespace pencil {

/// Points and directions in scene units: recentred and scaled by a power of two so that coordinates are at most 2 in magnitude.
struct Ray {
    glm::vec3 origin, direction;                       // any length
    float length = std::numeric_limits<float>::max();  // of the segment, in units of the direction
};

/// What a shape emits, to the front.
struct SurfaceEmission {
    glm::vec3 radiance{0.0F};
    float light_density = 0;   // of light sampling: probability per area of this shape [1 / scene units^2]
    int texture = no_texture;  // times radiance
};

struct RayHit {
    glm::vec3 point;
    glm::vec3 normal;   // geometric, unit, on the side that was hit
    glm::vec3 shading;  // interpolated vertex normal on that side, unit; the geometric one where there is none
    float distance;     // in units of the ray's direction
    float offset;       // along `normal`: further than the rounding error of `point`
    std::uint32_t shape, material;
    bool front;
    std::uint32_t triangle;
    float u, v;  // weights of its second and third corner
};

/// A triangle whose corners are rounded to single precision in scene units.
struct RayTriangle {
    glm::vec3 corner, edge1, edge2;
    glm::vec3 normal;  // unit, of the front
    float offset;      // see RayHit
    std::uint32_t shape, material;
};

class RayScene {
public:
    /// Builds the BVH on all cores. The scene must outlive this. Triangles that vanish in single precision are left out. MemoryError if Embree
    /// cannot get memory.
    explicit RayScene(const Scene& scene);

    /// The nearest triangle that the ray meets beyond its origin. Rays that are not finite meet nothing.
    bool intersect(const Ray& ray, RayHit& hit) const;
    /// Whether a triangle lies between the ends of the segment.
    bool occluded(const Ray& ray) const;

    const std::vector<RayTriangle>& triangles() const { return triangles_; }
    std::vector<SurfaceEmission>& emission() { return emission_; }  // one per shape
    const std::vector<SurfaceEmission>& emission() const { return emission_; }
    const SurfaceTable& surfaces() const { return surfaces_; }
    /// Texture coordinates and the like at a hit point.
    TexturePoint texture_point(const RayHit& hit) const { return texture_point(hit.triangle, hit.u, hit.v); }
    TexturePoint texture_point(std::uint32_t triangle, float u, float v) const;
    /// Radiance of the front at a place of a triangle.
    glm::vec3 emitted(std::uint32_t triangle, float u, float v) const;

    glm::dvec3 to_scene(const glm::dvec3& world) const { return (world - centre_) / scale_; }
    glm::dvec3 to_world(const glm::dvec3& point) const { return centre_ + point * scale_; }
    double scale() const { return scale_; }  // world units per scene unit
    double light() const { return light_; }  // unit of all light (light_unit.h)
    const glm::dvec3& low() const { return low_; }
    const glm::dvec3& high() const { return high_; }  // bounds of the triangles [scene units]

private:
    void normalise(const Scene& scene);
    std::vector<glm::uvec3> add_triangles(const Scene& scene);
    void build(const std::vector<glm::uvec3>& corners);
    glm::vec3 shading_normal(std::uint32_t triangle, float u, float v, const RayHit& hit) const;

    struct Release {
        void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
        void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
        void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
    };
    glm::dvec3 centre_{0.0}, low_{0.0}, high_{0.0};
    double scale_ = 1.0, light_ = 1.0;
    std::vector<glm::vec3> vertices_;  // while it is built
    std::vector<RayTriangle> triangles_;
    std::vector<glm::vec3> normals_;  // three per triangle, empty if no shape has vertex normals
    std::vector<SurfaceEmission> emission_;
    std::vector<glm::vec2> uvs_;      // three per triangle, empty if nothing asks for them
    std::vector<glm::vec3> colours_;  // three per triangle, empty if no shape has any
    SurfaceTable surfaces_;
    std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release> device_;
    std::unique_ptr<std::remove_pointer_t<RTCScene>, Release> bvh_;
};

}  // namespace pencil
