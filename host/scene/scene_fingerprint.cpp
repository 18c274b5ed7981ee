#include "scene/scene_fingerprint.h"

#include <glm/gtc/type_ptr.hpp>
#include <type_traits>

#include "util/fingerprint.h"

namespace pencil {
namespace {

/// Of values.
class Hash : public Fingerprint {
public:
    template <typename T>
    void add(T value) {
        static_assert(std::is_arithmetic_v<T>, "structures have padding");
        add_bytes(&value, sizeof(value));
    }
    void add(const glm::vec3& v) { add_bytes(glm::value_ptr(v), 3 * sizeof(float)); }
    void add(const glm::vec2& v) { add_bytes(glm::value_ptr(v), 2 * sizeof(float)); }
    void add(const glm::dvec2& v) { add_bytes(glm::value_ptr(v), 2 * sizeof(double)); }
    void add(const glm::dvec3& v) { add_bytes(glm::value_ptr(v), 3 * sizeof(double)); }
    void add(const glm::dmat3& m) { add_bytes(glm::value_ptr(m), 9 * sizeof(double)); }
    void add(const glm::dmat4& m) { add_bytes(glm::value_ptr(m), 16 * sizeof(double)); }
    template <typename T>
    void add_all(const std::vector<T>& values) {
        add(values.size());
        add_bytes(values.data(), values.size() * sizeof(T));
    }
};

/// By corners, not by vertices: how triangles share vertices, or texture coordinates split them, changes no picture.
void add_geometry(Hash& hash, const Scene& scene) {
    const bool wants_uvs = !scene.textures.empty() && !scene.uvs.empty();  // without a texture they change no picture
    hash.add(scene.triangles.size());
    for (const Triangle3& triangle : scene.triangles) {
        for (int k = 0; k < 3; ++k) {
            hash.add(scene.positions[triangle.corners[k]]);
            hash.add(scene.normals[triangle.corners[k]]);
            if (wants_uvs) hash.add(scene.uvs[triangle.corners[k]]);
            if (!scene.colours.empty()) hash.add(scene.colours[triangle.corners[k]]);
        }
        hash.add(triangle.shape);
        hash.add(triangle.material);
    }
}

void add_textures(Hash& hash, const Scene& scene) {
    for (const Texture& texture : scene.textures) {
        hash.add(static_cast<int>(texture.kind));
        hash.add(texture.to_uv);
        for (const int value : {texture.width, texture.height, static_cast<int>(texture.nearest), static_cast<int>(texture.wrap_u),
                                static_cast<int>(texture.wrap_v)})
            hash.add(value);
        hash.add_all(texture.texels);
        for (const glm::vec3& colour : texture.colours) hash.add(colour);
    }
}

void add_principled(Hash& hash, const PrincipledParameters& d) {
    for (const float value :
         {d.metallic, d.anisotropic, d.spec_trans, d.spec_tint, d.sheen, d.sheen_tint, d.flatness, d.clearcoat, d.clearcoat_gloss})
        hash.add(value);
    hash.add(d.metallic_texture);
}

void add_material(Hash& hash, const SceneMaterial& m) {
    for (const int value :
         {m.model, m.albedo_texture, m.specular_texture, m.transmitted_texture, m.alpha_texture, m.weight_texture, m.normal_texture})
        hash.add(value);
    for (const bool value : {m.two_sided, m.perfect_mirror, m.beckmann, m.nonlinear, m.thin, m.weight_is_opacity, m.bump, m.y_against_v})
        hash.add(value);
    for (const glm::vec3& value : {m.albedo, m.parameters, m.specular, m.transmitted, m.eta, m.k}) hash.add(value);
    for (const std::int64_t value : {m.back, m.blended[0], m.blended[1]}) hash.add(value);
    for (const float value : {m.exponent, m.weight, m.bump_scale}) hash.add(value);
    hash.add(m.alpha);
    add_principled(hash, m.principled);
}

void add_emission(Hash& hash, const Scene& scene) {
    for (const Shape& shape : scene.shapes) {
        hash.add(shape.emits);
        hash.add(shape.radiance);
        hash.add(shape.radiance_texture);
    }
}

void add_lights(Hash& hash, const Scene& scene) {
    for (const PointLight& light : scene.point_lights) {
        hash.add(light.position);
        hash.add(light.intensity);
        hash.add(light.is_spot);
        hash.add(light.profile);
        if (!light.is_spot && light.profile < 0) continue;  // it has no axis
        hash.add(light.to_world);
        hash.add(light.cutoff);
        hash.add(light.beam_width);
    }
    for (const LightProfile& profile : scene.profiles) {
        hash.add_all(profile.vertical);
        hash.add_all(profile.horizontal);
        hash.add_all(profile.values);
    }
    for (const DirectionalLight& light : scene.directional_lights) {
        hash.add(light.direction);
        hash.add(light.irradiance);
    }
    if (!scene.environment) return;
    const Environment& environment = *scene.environment;
    hash.add(environment.radiance);
    hash.add(environment.width);
    hash.add(environment.height);
    hash.add_all(environment.texels);
    hash.add(environment.to_world);
}

void add_sensor(Hash& hash, const PerspectiveSensor& sensor) {
    hash.add(sensor.to_world);
    hash.add(sensor.principal_point_offset);
    hash.add(sensor.orthographic);
    hash.add(sensor.aperture_radius);
    hash.add(sensor.focus_distance);
    for (const double value :
         {sensor.fov_x, sensor.near_clip, sensor.far_clip, sensor.filter.radius, sensor.filter.stddev, sensor.filter.b, sensor.filter.c})
        hash.add(value);
    hash.add(static_cast<int>(sensor.filter.kind));
    for (const int value : {sensor.crop_x, sensor.crop_y, sensor.crop_width, sensor.crop_height}) hash.add(value);
}

}  // namespace

std::string scene_fingerprint(const Scene& scene) {
    Hash hash;
    add_geometry(hash, scene);
    add_textures(hash, scene);
    add_emission(hash, scene);
    for (const SceneMaterial& material : scene.materials) add_material(hash, material);
    add_lights(hash, scene);
    add_sensor(hash, scene.sensor);
    return hash.text();
}

}  // namespace pencil
