#include "scene/scene_fingerprint.h"

#include <cstdio>
#include <glm/gtc/type_ptr.hpp>
#include <type_traits>

namespace pencil {
namespace {

/// Fowler, Noll and Vo's hash, variant 1a.
class Hash {
public:
    void add_bytes(const void* data, std::size_t bytes) {
        const std::uint64_t prime = 0x100000001b3;
        const auto* next = static_cast<const unsigned char*>(data);
        for (const unsigned char* end = next + bytes; next != end; ++next) value_ = (value_ ^ *next) * prime;
    }
    template <typename T>
    void add(T value) {
        static_assert(std::is_arithmetic_v<T>, "structures have padding");
        add_bytes(&value, sizeof(value));
    }
    void add(const glm::vec3& v) { add_bytes(glm::value_ptr(v), 3 * sizeof(float)); }
    void add(const glm::dvec3& v) { add_bytes(glm::value_ptr(v), 3 * sizeof(double)); }

    std::string text() const {
        char digits[17];
        std::snprintf(digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(value_));
        return digits;
    }

private:
    std::uint64_t value_ = 0xcbf29ce484222325;
};

/// By corners, not by vertices: how triangles share vertices, or texture coordinates split them, changes no picture.
void add_geometry(Hash& hash, const Scene& scene) {
    hash.add(scene.triangles.size());
    for (const Triangle3& triangle : scene.triangles) {
        for (int k = 0; k < 3; ++k) {
            hash.add(scene.positions[triangle.corners[k]]);
            hash.add(scene.normals[triangle.corners[k]]);
        }
        hash.add(triangle.shape);
        hash.add(triangle.material);
    }
}

void add_materials_and_lights(Hash& hash, const Scene& scene) {
    for (const Shape& shape : scene.shapes) {
        hash.add(shape.emits);
        hash.add(shape.radiance);
    }
    for (const SceneMaterial& material : scene.materials) {
        hash.add(material.model);
        hash.add(material.albedo);
        hash.add(material.two_sided);
    }
    for (const PointLight& light : scene.point_lights) {
        hash.add(light.position);
        hash.add(light.intensity);
    }
}

void add_sensor(Hash& hash, const PerspectiveSensor& sensor) {
    hash.add_bytes(glm::value_ptr(sensor.to_world), 16 * sizeof(double));
    hash.add_bytes(glm::value_ptr(sensor.principal_point_offset), 2 * sizeof(double));
    for (const double value :
         {sensor.fov_x, sensor.near_clip, sensor.far_clip, sensor.filter.radius, sensor.filter.stddev, sensor.filter.b, sensor.filter.c})
        hash.add(value);
    hash.add(static_cast<int>(sensor.filter.kind));
}

}  // namespace

std::string scene_fingerprint(const Scene& scene) {
    Hash hash;
    add_geometry(hash, scene);
    add_materials_and_lights(hash, scene);
    add_sensor(hash, scene.sensor);
    return hash.text();
}

std::string fingerprint(const void* data, std::size_t bytes) {
    Hash hash;
    hash.add_bytes(data, bytes);
    return hash.text();
}

}  // namespace pencil
