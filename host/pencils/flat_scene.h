// The scene flattened for the device: normalised coordinates, planes shared by coplanar neighbours, one material per shape.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"
#include "shared/camera.h"
#include "shared/geometry.h"
#include "shared/material.h"
#include "shared/types.h"

namespace pencil {

/// world = centre + point * scale; scale is a power of two, so normalising loses no bit beyond the recentring.
struct Normalisation {
    glm::dvec3 centre{0.0};
    double scale = 1.0;
    glm::dvec3 to_scene(const glm::dvec3& world) const { return (world - centre) / scale; }
    glm::dvec3 to_world(const glm::dvec3& point) const { return centre + point * scale; }
};

struct FlatScene {
    Normalisation normalisation;
    std::vector<Triangle> triangles;
    std::vector<float4> planes;       // unit normal, distance: dot(normal, x) = w on the plane
    std::vector<Material> materials;  // one per shape
    std::vector<float4> normals;      // three per triangle, empty if no shape has vertex normals
    Camera camera{};
    std::vector<float4> to_film;     // three rows, see bound_film.cl
    glm::dvec3 low{0.0}, high{0.0};  // bounds of geometry and lights [scene units]
};

/// Normal of the front times the area [scene units^2].
inline glm::dvec3 area_vector(const Triangle& t) {
    return 0.5 * glm::cross(glm::dvec3(t.v1) - glm::dvec3(t.v0), glm::dvec3(t.v2) - glm::dvec3(t.v0));
}

/// How an emitting shape's light enters: by light samples, or carried by the pencil maps.
enum class LightForm { samples, maps };

/// `forms` has one entry per shape, ignored where the shape does not emit. Width and height 0: the scene's own.
FlatScene flatten(const Scene& scene, const std::vector<LightForm>& forms, int width, int height);

/// Area of each shape [world units^2].
std::vector<double> shape_areas(const Scene& scene);

}  // namespace pencil
