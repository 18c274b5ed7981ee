// Material libraries of Wavefront OBJ.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "util/error.h"

namespace pencil {

constexpr std::uintmax_t max_mtl_bytes = std::uintmax_t{16} << 20;

/// A picture that a material names, with its options.
struct MtlMap {
    std::string file;                    // empty: none
    glm::dvec3 offset{0.0}, scale{1.0};  // -o, -s: of texture coordinates whose v grows upwards
    bool clamp = false;
    double bump_multiplier = 1;  // -bm
};

/// Statements as the file gives them; what it does not give is empty.
struct MtlMaterial {
    std::string name;
    std::optional<glm::dvec3> diffuse, specular, emission, filter;                      // Kd, Ks, Ke, Tf
    std::optional<double> exponent, opacity, index, roughness, metallic;                // Ns, d or 1 - Tr, Ni, Pr, Pm
    std::optional<int> model;                                                           // illum
    MtlMap diffuse_map, specular_map, emission_map, opacity_map, bump_map, normal_map;  // map_Kd, map_Ks, map_Ke, map_d, map_Bump, norm
    std::vector<std::string> left_out;                                                  // statements that say something and are not read
};

/// `name` is the file's name for messages. Statements that are not listed here are skipped, and so are those with a defect, which goes to
/// `defects`.
std::vector<MtlMaterial> read_mtl(std::string_view text, const std::string& name, std::vector<SceneError>& defects);

}  // namespace pencil
