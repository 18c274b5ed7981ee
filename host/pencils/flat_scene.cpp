#include "pencils/flat_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <map>
#include <stdexcept>
#include <utility>

#include "pencils/flat_sky.h"
#include "pencils/material_rows.h"
#include "pencils/profile_table.h"
#include "scene/split_triangle.h"

namespace pencil {

namespace {

/// Vertices this near a plane, in terms of the largest coordinate but at most of a scene unit, lie in it: the rounding of float coordinates.
constexpr double coplanar = 2e-7;

struct Plane3 {
    glm::dvec3 normal;
    double distance;
};

Normalisation normalise(const Scene& scene) {
    glm::dvec3 low(HUGE_VAL), high(-HUGE_VAL);
    auto grow = [&](const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    };
    for (const Triangle3& t : scene.triangles)
        for (int k = 0; k < 3; ++k) grow(scene.positions[t.corners[k]]);
    for (const PointLight& light : scene.point_lights) grow(light.position);
    Normalisation n;
    if (low.x > high.x) return n;
    n.centre = glm::clamp(glm::dvec3(scene.sensor.to_world[3]), low, high);
    double extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    if (extent > 0) n.scale = std::exp2(std::ceil(std::log2(extent)) - 1);  // extent / scale in (1, 2]
    return n;
}

float4 to_float4(const glm::dvec3& v, double w = 0) {
    return float4(static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w));
}

Plane3 plane_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
    return {normal, glm::dot(normal, a)};
}

bool contains(const Plane3& plane, const Plane3& other, const glm::dvec3* corners) {
    if (glm::dot(plane.normal, other.normal) < 0.9) return false;
    double largest = 0;
    for (int k = 0; k < 3; ++k) largest = std::max({largest, std::abs(corners[k].x), std::abs(corners[k].y), std::abs(corners[k].z)});
    const double tolerance = coplanar * std::min(largest, 1.0);
    for (int k = 0; k < 3; ++k)
        if (std::abs(glm::dot(plane.normal, corners[k]) - plane.distance) > tolerance) return false;
    return true;
}

/// The vertex normal at barycentric weights; of shapes without, 0.
glm::vec3 interpolated(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::dvec3& weights) {
    const glm::vec3 w(weights), sum = w.x * a + w.y * b + w.z * c;
    return glm::dot(sum, sum) > 0.0F ? glm::normalize(sum) : glm::vec3(0.0F);
}

/// Texture coordinates, and colours if the scene has any, of the corners of a triangle or of a piece of it.
void add_texture_points(const Scene& scene, const Triangle3& t, const glm::dvec3* weights, std::vector<std::uint64_t>& colours,
                        FlatScene& flat) {
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 w = weights == nullptr ? glm::dvec3(k == 0, k == 1, k == 2) : weights[k];
        glm::dvec2 uv(0);
        glm::dvec3 colour(0);
        for (int c = 0; c < 3; ++c) {
            if (!scene.uvs.empty()) uv += w[c] * glm::dvec2(scene.uvs[t.corners[c]]);
            if (!scene.colours.empty()) colour += w[c] * glm::dvec3(scene.colours[t.corners[c]]);
        }
        flat.uvs.emplace_back(uv);
        if (!scene.colours.empty()) colours.push_back(glm::packHalf4x16(glm::vec4(glm::vec3(colour), 1.0F)));
    }
}

void flatten_triangles(const Scene& scene, MaterialRows& rows, FlatScene& flat) {
    std::vector<glm::dvec3> points;
    points.reserve(scene.positions.size());
    for (const glm::dvec3& p : scene.positions) points.push_back(glm::dvec3(glm::vec3(flat.normalisation.to_scene(p))));
    const bool textured = !flat.textures.empty();
    std::vector<std::uint64_t> colours;  // of vertices
    bool smooth = std::any_of(scene.normals.begin(), scene.normals.end(), [](const glm::vec3& n) { return n != glm::vec3(0); });
    const TriangleSplitter splitter(glm::dvec3(scene.sensor.to_world[3]), scene.sensor.near_clip);
    Plane3 last{};
    Triangle neighbour{};
    neighbour.shape = -1;
    const auto add = [&](const Triangle3& t, const glm::dvec3* corners, const Plane3& own, const glm::dvec3* weights) {
        if (glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0])) == 0) return;  // vanished in float
        const int shape = static_cast<int>(t.shape), row = rows.of(t);
        // Consecutive triangles of one shape and material share a plane: quads, cube faces, polygon fans, flat grids.
        if (shape != neighbour.shape || row != neighbour.material || !contains(last, own, corners)) {
            flat.planes.push_back(to_float4(own.normal, own.distance));
            last = own;
        }
        neighbour = {
            to_float4(corners[0]), to_float4(corners[1]), to_float4(corners[2]), static_cast<int>(flat.planes.size()) - 1, row, shape, 0};
        flat.triangles.push_back(neighbour);
        const auto normal = [&](int k) { return scene.normals[t.corners[k]]; };
        for (int k = 0; smooth && k < 3; ++k)
            flat.normals.push_back(
                float4(weights == nullptr ? normal(k) : interpolated(normal(0), normal(1), normal(2), weights[k]), 0.0F));
        if (textured) add_texture_points(scene, t, weights, colours, flat);
    };
    for (const Triangle3& t : scene.triangles) {
        const glm::dvec3 *world = scene.positions.data(), corners[3] = {points[t.corners.x], points[t.corners.y], points[t.corners.z]};
        const std::vector<TrianglePiece> pieces = splitter.split(world[t.corners.x], world[t.corners.y], world[t.corners.z]);
        if (pieces.size() == 1) {
            if (glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0])) > 0)
                add(t, corners, plane_of(corners[0], corners[1], corners[2]), nullptr);
            continue;
        }
        // Pieces lie in the plane of the whole: rounded corners of far ones would turn it.
        const auto& to = flat.normalisation;
        const Plane3 plane = plane_of(to.to_scene(world[t.corners.x]), to.to_scene(world[t.corners.y]), to.to_scene(world[t.corners.z]));
        for (const TrianglePiece& piece : pieces) {
            glm::dvec3 rounded[3];
            for (std::size_t k = 0; k < 3; ++k) rounded[k] = glm::dvec3(glm::vec3(to.to_scene(piece.corner[k])));
            add(t, rounded, plane, piece.weight.data());
        }
    }
    for (TextureRow& texture : flat.textures)
        if (texture.kind == TEXTURE_VERTEX_COLOURS) texture.first = static_cast<int>(flat.texels.size());
    flat.texels.insert(flat.texels.end(), colours.begin(), colours.end());
}

/// Counts the mates of each triangle: neighbours in the list that share its plane.
void count_mates(std::vector<Triangle>& triangles) {
    constexpr std::ptrdiff_t most_mates = 12;  // on each side: walls with a door and some windows have all of theirs
    const auto size = static_cast<std::ptrdiff_t>(triangles.size());
    auto same = [&](std::ptrdiff_t i, std::ptrdiff_t k) {
        return k >= 0 && k < size && triangles[static_cast<std::size_t>(k)].plane == triangles[static_cast<std::size_t>(i)].plane;
    };
    for (std::ptrdiff_t i = 0; i < size; ++i) {
        int before = 0, after = 0;
        while (before < most_mates && same(i, i - before - 1)) ++before;
        while (after < most_mates && same(i, i + after + 1)) ++after;
        triangles[static_cast<std::size_t>(i)].mates = before | after << 8;
    }
}

}  // namespace

void flatten_camera(const PerspectiveSensor& sensor, int width, int height, FlatScene& flat) {
    const bool cropped = sensor.crop_width > 0;
    const double shrink_x = cropped ? static_cast<double>(width) / sensor.crop_width : 1.0,
                 shrink_y = cropped ? static_cast<double>(height) / sensor.crop_height : 1.0;
    const double whole_x = cropped ? sensor.width * shrink_x : width, whole_y = cropped ? sensor.height * shrink_y : height;
    const double tan_x = sensor.orthographic ? 1.0 : std::tan(sensor.fov_x * 3.14159265358979323846 / 360.0);
    const double pixel = 2.0 * tan_x / whole_x;  // at unit depth
    glm::dvec3 left = glm::normalize(glm::dvec3(sensor.to_world[0]));
    glm::dvec3 up = glm::normalize(glm::dvec3(sensor.to_world[1]));
    glm::dvec3 forward = glm::normalize(glm::dvec3(sensor.to_world[2]));
    glm::dvec3 step_x = -left * pixel, step_y = -up * pixel;
    const double centre_x = whole_x * (0.5 + sensor.principal_point_offset.x) - (cropped ? sensor.crop_x * shrink_x : 0.0),
                 centre_y = whole_y * (0.5 + sensor.principal_point_offset.y) - (cropped ? sensor.crop_y * shrink_y : 0.0);
    glm::dvec3 corner = forward - step_x * centre_x - step_y * centre_y;
    const double scale = flat.normalisation.scale;
    flat.camera = {};
    Camera& camera = flat.camera;
    camera.origin = to_float4(flat.normalisation.to_scene(glm::dvec3(sensor.to_world[3])));
    camera.corner = to_float4(corner);
    camera.step_x = to_float4(step_x);
    camera.step_y = to_float4(step_y);
    flat.eye = flat.normalisation.to_scene(glm::dvec3(sensor.to_world[3]));
    if (sensor.orthographic) {
        // The film has the size that to_world gives it.
        const double wide = glm::length(glm::dvec3(sensor.to_world[0])) / scale, high = glm::length(glm::dvec3(sensor.to_world[1])) / scale;
        const glm::dvec3 right = step_x * wide, down = step_y * high;
        camera.shift_x = to_float4(right);
        camera.shift_y = to_float4(down);
        camera.origin = to_float4(flat.eye - centre_x * right - centre_y * down);
        camera.corner = to_float4(forward);
        camera.step_x = camera.step_y = float4(0);
        flat.eye -= forward * (glm::length(right) * width);
    } else if (sensor.aperture_radius > 0) {
        const double radius = sensor.aperture_radius / scale;
        camera.lens_x = to_float4(left * radius, sensor.focus_distance > 0 ? scale / sensor.focus_distance : 0.0);
        camera.lens_y = to_float4(up * radius);
    }
    camera.width = width;
    camera.height = height;
    camera.near_clip = static_cast<float>(sensor.near_clip / scale);
    camera.far_clip = static_cast<float>(sensor.far_clip / scale);
    // Rows of the inverse of (step_x, step_y, corner): point = depth * (corner + px step_x + py step_y).
    glm::dmat3 inverse = glm::inverse(glm::dmat3(step_x, step_y, corner));
    glm::dmat3 rows = glm::transpose(inverse);
    flat.to_film.clear();
    for (int k = 0; k < 3; ++k) flat.to_film.push_back(to_float4(rows[k]));
}

FlatScene flatten(const Scene& scene, const std::vector<LightForm>& forms, int width, int height, double unit) {
    FlatScene flat;
    flat.normalisation = normalise(scene);
    flat.normalisation.light = unit;
    flat.shape_count = static_cast<int>(scene.shapes.size());
    flat.textures = flatten_textures(scene, flat.texels);
    flat.far_light =
        !scene.directional_lights.empty() || std::any_of(scene.point_lights.begin(), scene.point_lights.end(),
                                                         [](const PointLight& light) { return light.is_spot || light.profile >= 0; });
    for (const PointLight& light : scene.point_lights)
        flat.profile_tables.push_back(
            light.profile >= 0 ? add_profile_table(light, scene.profiles[static_cast<std::size_t>(light.profile)], flat.texels) : -1);
    flat.sky = flatten_sky(scene, flat.sky_texels, unit);
    MaterialRows rows(scene, forms, flat.materials, flat.row_shapes, flat.texels, flat.normalisation.scale, unit);
    flatten_triangles(scene, rows, flat);
    count_mates(flat.triangles);
    if (!scene.sensor_points.empty()) flat.planes.emplace_back(0.0F);  // that sensors are on, and no triangle
    flatten_camera(scene.sensor, width > 0 ? width : scene.sensor.width, height > 0 ? height : scene.sensor.height, flat);
    glm::dvec3 low(HUGE_VAL), high(-HUGE_VAL);
    for (const Triangle& t : flat.triangles)
        for (const float4& v : {t.v0, t.v1, t.v2}) {
            low = glm::min(low, glm::dvec3(v));
            high = glm::max(high, glm::dvec3(v));
        }
    for (const PointLight& light : scene.point_lights) {
        low = glm::min(low, flat.normalisation.to_scene(light.position));
        high = glm::max(high, flat.normalisation.to_scene(light.position));
    }
    if (low.x <= high.x) {
        flat.low = low;
        flat.high = high;
    }
    return flat;
}

double cross_section(const FlatScene& flat) {
    const glm::dvec3 size = flat.high - flat.low;
    return (size.x * size.y + size.y * size.z + size.z * size.x) / 3;
}

std::vector<double> shape_areas(const Scene& scene) {
    std::vector<double> areas(scene.shapes.size(), 0.0);
    for (const Triangle3& t : scene.triangles) {
        const glm::dvec3 &a = scene.positions[t.corners.x], &b = scene.positions[t.corners.y], &c = scene.positions[t.corners.z];
        areas[t.shape] += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return areas;
}

}  // namespace pencil
