// Complex indices of refraction of measured conductors, by the names that Mitsuba gives them.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace pencil {

/// As components of linear sRGB.
struct ComplexIndex {
    glm::vec3 eta, k;
};

std::optional<ComplexIndex> metal(const std::string& name);
std::vector<std::string> metal_names();

}  // namespace pencil
