// Where fuzzers of scenes write their input, and what every scene must hold.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "fuzz/check_mesh.h"
#include "scene/scene.h"

namespace pencil::fuzz {

inline void write_file(const std::filesystem::path& file, const std::string& content) {
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    stream << content;
    require(stream.good());
}

/// A folder of this process, in memory where the system has such a place; gone when the process ends.
struct SceneFolder {
    SceneFolder() : path(root() / ("pencil_fuzz_" + std::to_string(getpid()))) { std::filesystem::create_directories(path); }
    SceneFolder(const SceneFolder&) = delete;
    SceneFolder& operator=(const SceneFolder&) = delete;
    ~SceneFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    static std::filesystem::path root() {
        return std::filesystem::is_directory("/dev/shm") ? std::filesystem::path("/dev/shm") : std::filesystem::temp_directory_path();
    }

    std::filesystem::path path;
};

inline void check_texture(const Scene& scene, int texture) {
    require(texture == no_texture || (texture >= 0 && static_cast<std::size_t>(texture) < scene.textures.size()));
}

/// Numbers are finite and indices lead somewhere.
inline void check_scene(const Scene& scene) {
    for (const glm::dvec3& position : scene.positions) require(is_finite(position));
    for (const Triangle3& t : scene.triangles) {
        require(t.shape < scene.shapes.size());
        require(t.material < scene.materials.size());
        for (int k = 0; k < 3; ++k) require(t.corners[k] < scene.positions.size());
    }
    require(scene.normals.size() == scene.positions.size());
    require(scene.uvs.empty() || scene.uvs.size() == scene.positions.size());
    require(scene.colours.empty() || scene.colours.size() == scene.positions.size());
    for (const Shape& shape : scene.shapes) {
        require(is_finite(glm::dvec3(shape.radiance)));
        check_texture(scene, shape.radiance_texture);
    }
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const SceneMaterial& m = scene.materials[i];
        for (const int texture : {m.albedo_texture, m.specular_texture, m.transmitted_texture, m.alpha_texture, m.weight_texture,
                                  m.normal_texture, m.principled.metallic_texture})
            check_texture(scene, texture);
        if (m.model == MATERIAL_BLEND)
            for (const std::int64_t blended : m.blended) require(blended >= 0 && static_cast<std::size_t>(blended) < i);
        require(is_finite(glm::dvec3(m.albedo)) && is_finite(glm::dvec3(m.eta)) && std::isfinite(m.alpha.x) && std::isfinite(m.weight));
    }
    for (const Texture& texture : scene.textures)
        require(texture.texels.size() == static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height));
    for (const PointLight& light : scene.point_lights) require(is_finite(light.position) && is_finite(glm::dvec3(light.intensity)));
    for (int i = 0; i < 4; ++i) require(is_finite(glm::dvec3(scene.sensor.to_world[i])));
    require(scene.sensor.width > 0 && scene.sensor.height > 0 && scene.sensor.near_clip < scene.sensor.far_clip);
}

}  // namespace pencil::fuzz
