#include "scene/gltf/read_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "scene/gltf/turned_frame.h"
#include "util/constants.h"

namespace pencil {
namespace {

constexpr double very_far = 1e18;

/// The film's size in pixels for a ratio of width to height.
void set_film(double aspect, PerspectiveSensor& sensor) {
    const int longer = sensor.width;
    const auto pixels = [](double size) { return std::max(static_cast<int>(std::lround(size)), 1); };
    sensor.width = pixels(longer * std::min(aspect, 1.0));
    sensor.height = pixels(longer / std::max(aspect, 1.0));
}

void check(bool holds, const GltfFile& file, const std::string& label, const char* demand) {
    if (!holds) file.fail(label + ": " + demand);
}

void read_perspective(const GltfFile& file, const tinygltf::PerspectiveCamera& camera, const std::string& label,
                      PerspectiveSensor& sensor) {
    check(camera.yfov > 0 && camera.yfov < pi, file, label, "yfov must lie between 0 and pi, both excluded");
    check(camera.znear > 0 && camera.znear < very_far, file, label, "znear must be positive");
    check(camera.aspectRatio >= 0 && camera.aspectRatio < 1e3 && !(camera.aspectRatio > 0 && camera.aspectRatio < 1e-3), file, label,
          "aspectRatio must lie between 0.001 and 1000");
    if (camera.aspectRatio > 0) set_film(camera.aspectRatio, sensor);
    const double across = std::tan(camera.yfov / 2) * sensor.width / sensor.height;  // the film's own ratio: pixels are square
    sensor.fov_x = 2 * glm::degrees(std::atan(across));
    sensor.near_clip = camera.znear;
}

void read_orthographic(const GltfFile& file, const tinygltf::OrthographicCamera& camera, const std::string& label,
                       PerspectiveSensor& sensor) {
    const double x = std::abs(camera.xmag), y = std::abs(camera.ymag), aspect = x / y;
    check(x > 0 && y > 0 && x < very_far && y < very_far && aspect < 1e3 && aspect > 1e-3, file, label, "xmag and ymag must be positive");
    check(camera.znear >= 0 && camera.znear < very_far, file, label, "znear must not be negative");
    set_film(aspect, sensor);
    sensor.orthographic = true;
    sensor.to_world[0] *= x;  // [-1, 1] of its own x is what it sees
    sensor.to_world[1] *= x;
    sensor.near_clip = std::max(camera.znear, 1e-9 * x);
}

}  // namespace

PerspectiveSensor read_camera(GltfFile& file, int index, const glm::dmat4& to_world, const std::string& user) {
    const tinygltf::Camera& camera = file.at(file.model().cameras, index, "camera", user);
    const std::string label = named("camera", static_cast<std::size_t>(index), camera.name);
    const std::optional<glm::dmat4> frame = turned_frame(to_world);
    check(frame.has_value(), file, label, "its node has no directions: the scale is zero");
    check(is_in_range(glm::dvec3((*frame)[3])), file, label, "it lies further than 1e18 from the origin");
    PerspectiveSensor sensor;
    sensor.to_world = *frame;
    sensor.far_clip = very_far;
    if (camera.type == "orthographic")
        read_orthographic(file, camera.orthographic, label, sensor);
    else
        read_perspective(file, camera.perspective, label, sensor);
    return sensor;
}

}  // namespace pencil
