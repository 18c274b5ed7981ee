// The scene flattened for the device: normalised coordinates, planes shared by coplanar neighbours, rows of materials.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "pencils/light_form.h"
#include "scene/light_unit.h"
#include "scene/scene.h"
#include "shared/camera.h"
#include "shared/geometry.h"
#include "shared/material.h"
#include "shared/sky.h"
#include "shared/texture.h"
#include "shared/types.h"

namespace pencil {

/// world = centre + point * scale; scale is a power of two, so normalising loses no bit beyond the recentring. So is the unit of light.
struct Normalisation {
    glm::dvec3 centre{0.0};
    double scale = 1.0;
    double light = 1.0;  // radiance of the scene file per radiance on the device (light_unit.h)
    glm::vec3 to_light(const glm::dvec3& emitted) const { return in_light_unit(emitted, light); }
    glm::dvec3 to_scene(const glm::dvec3& world) const { return (world - centre) / scale; }
    glm::dvec3 to_world(const glm::dvec3& point) const { return centre + point * scale; }
};

struct FlatScene {
    Normalisation normalisation;
    std::vector<Triangle> triangles;
    std::vector<float4> planes;       // unit normal, distance: dot(normal, x) = w on the plane; of sensors, the last, 0
    std::vector<Material> materials;  // one per scene material in use on what does not emit; own ones for each shape that emits
    std::vector<int> row_shapes;      // the shape that a row is of, if it emits, else -1
    std::vector<float4> normals;      // three per triangle, empty if no shape has vertex normals
    std::vector<TextureRow> textures;
    std::vector<std::uint64_t> texels;  // four half floats each
    std::vector<glm::vec2> uvs;         // three per triangle, empty if no material has a texture
    bool far_light = false;             // directional lights, spots or profiles
    std::vector<int> profile_tables;    // of point lights: first texel, -1: it has no profile
    Sky sky{};
    std::vector<float4> sky_texels;
    int shape_count = 0;  // of Scene::shapes, which Triangle::shape indexes
    Camera camera{};
    glm::dvec3 eye{0.0};  // where the film is seen from, of parallel rays a point behind it [scene units]
    bool is_wide_camera() const { return camera.lens_x != float4(0) || camera.shift_x != float4(0); }
    std::vector<float4> to_film;     // three rows, see bound_film.cl
    glm::dvec3 low{0.0}, high{0.0};  // bounds of geometry and lights [scene units]
};

/// Normal of the front times the area [scene units^2].
inline glm::dvec3 area_vector(const Triangle& t) {
    return 0.5 * glm::cross(glm::dvec3(t.v1) - glm::dvec3(t.v0), glm::dvec3(t.v2) - glm::dvec3(t.v0));
}

/// Area of the scene as seen from outside, about, for light that comes from there [scene units^2].
double cross_section(const FlatScene& flat);

/// The scene's camera, in place of the one it has; `width`, `height`: of the part of its film that is rendered. Mitsuba's sensors: +z forward, +x
/// to the left, fov_x over the film's width; parallel rays through [-1, 1] of its own x.
void flatten_camera(const PerspectiveSensor& sensor, int width, int height, FlatScene& flat);

/// `forms` has one entry per shape, ignored where the shape does not emit. Width and height 0: the scene's own. `unit`: Normalisation::light.
FlatScene flatten(const Scene& scene, const std::vector<LightForm>& forms, int width, int height, double unit = 1.0);

/// Area of each shape [world units^2].
std::vector<double> shape_areas(const Scene& scene);

}  // namespace pencil
