// Scenes built in memory for the law tests, and access to the layers of a result, without a device. Right-handed, y up, corners
// counter-clockwise seen from the front, world units as they come.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "options/layer.h"
#include "scene/scene.h"

namespace pencil::test {

using glm::dvec3;

struct Surface {
    glm::vec3 albedo{0.5F};
    glm::vec3 radiance{0.0F};
    bool two_sided = false;
};

using Face = std::array<dvec3, 3>;

/// One shape of flat triangles.
inline void add_shape(Scene& scene, const std::string& id, const std::vector<Face>& faces, const Surface& surface) {
    Shape shape;
    shape.id = id;
    shape.kind = "obj";
    shape.first_triangle = static_cast<std::uint32_t>(scene.triangles.size());
    shape.triangle_count = static_cast<std::uint32_t>(faces.size());
    shape.emits = surface.radiance != glm::vec3(0.0F);
    shape.radiance = surface.radiance;
    const auto number = static_cast<std::uint32_t>(scene.shapes.size()), material = static_cast<std::uint32_t>(scene.materials.size());
    scene.materials.push_back({id, MATERIAL_DIFFUSE, surface.albedo, surface.two_sided, glm::vec3(0.0F)});
    for (const Face& face : faces) {
        const auto first = static_cast<std::uint32_t>(scene.positions.size());
        scene.positions.insert(scene.positions.end(), face.begin(), face.end());
        scene.normals.insert(scene.normals.end(), 3, glm::vec3(0.0F));
        scene.triangles.push_back({{first, first + 1, first + 2}, number, material});
    }
    scene.shapes.push_back(shape);
}

/// Rectangle corner, corner + u, corner + u + v, corner + v; its front is the side cross(u, v) points to.
inline void add_quad(Scene& scene, const std::string& id, const dvec3& corner, const dvec3& u, const dvec3& v, const Surface& surface) {
    add_shape(scene, id, {{corner, corner + u, corner + u + v}, {corner, corner + u + v, corner + v}}, surface);
}

/// Wall `2 * axis + side` of the box low..high, side 0 at low; its front looks into the box, or out of it.
inline void add_wall(Scene& scene, int wall, const dvec3& low, const dvec3& high, const Surface& surface, bool inward = true) {
    const int axis = wall / 2, a = (axis + 1) % 3, b = (axis + 2) % 3;
    dvec3 corner = low, u(0.0), v(0.0);
    u[a] = high[a] - low[a];
    v[b] = high[b] - low[b];  // cross(u, v) points to +axis
    if (wall % 2 == 1) corner[axis] = high[axis];
    if ((wall % 2 == 1) == inward) std::swap(u, v);
    add_quad(scene, "wall " + std::to_string(wall), corner, u, v, surface);
}

inline void add_box(Scene& scene, const dvec3& low, const dvec3& high, const Surface& surface, bool inward = true) {
    for (int wall = 0; wall < 6; ++wall) add_wall(scene, wall, low, high, surface, inward);
}

/// Pinhole at `origin` towards `target` with a box filter, so that a pixel is the mean over its own square.
inline void look_at(Scene& scene, const dvec3& origin, const dvec3& target, const dvec3& up, double fov, int width, int height) {
    const dvec3 forward = glm::normalize(target - origin), left = glm::normalize(glm::cross(up, forward)),
                above = glm::cross(forward, left);
    PerspectiveSensor& sensor = scene.sensor;
    sensor.to_world = glm::dmat4(glm::dvec4(left, 0), glm::dvec4(above, 0), glm::dvec4(forward, 0), glm::dvec4(origin, 1));
    sensor.fov_x = fov;
    sensor.near_clip = 1e-4;
    sensor.width = width;
    sensor.height = height;
    sensor.filter.kind = ReconstructionFilter::Kind::box;
    sensor.filter.radius = 0.5;
}

inline const Layer& layer(const std::vector<Layer>& layers, const std::string& name) {
    static const Layer missing;
    for (const Layer& candidate : layers)
        if (candidate.name == name) return candidate;
    ADD_FAILURE() << "no layer \"" << name << "\"";
    return missing;
}

inline dvec3 pixel(const Layer& image, std::size_t index) {
    const std::size_t at = index * static_cast<std::size_t>(image.channels);
    return {image.pixels.at(at), image.pixels.at(at + 1), image.pixels.at(at + 2)};
}

inline std::size_t pixel_count(const Layer& image) { return image.pixels.size() / static_cast<std::size_t>(image.channels); }

/// Every pixel and channel within `relative` of `value`; names the worst.
inline void expect_uniform(const Layer& image, double value, double relative) {
    ASSERT_GT(image.pixels.size(), 0U) << "layer \"" << image.name << "\"";
    std::size_t worst = 0;
    const auto error = [&](std::size_t i) {
        const double e = std::abs(image.pixels[i] - value);
        return std::isfinite(e) ? e : 1e30;
    };
    for (std::size_t i = 1; i < image.pixels.size(); ++i)
        if (error(i) > error(worst)) worst = i;
    EXPECT_LE(error(worst), relative * std::abs(value)) << "layer \"" << image.name << "\", float " << worst << " of "
                                                        << image.pixels.size() << ": " << image.pixels[worst] << " instead of " << value;
}

inline void expect_zero(const Layer& image) {
    ASSERT_GT(image.pixels.size(), 0U) << "layer \"" << image.name << "\"";
    std::size_t lit = 0, first = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        if (image.pixels[i] != 0.0F && lit++ == 0) first = i;
    EXPECT_EQ(lit, 0U) << "layer \"" << image.name << "\": first at float " << first << ": " << image.pixels[first];
}

}  // namespace pencil::test
