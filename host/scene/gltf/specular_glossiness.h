// KHR_materials_pbrSpecularGlossiness, the model of many older files, in terms of base colour and metallic.
#pragma once

#include <glm/vec3.hpp>

namespace pencil {

struct BaseAndMetallic {
    glm::vec3 base{0.0F};
    float metallic = 0;
};

/// The metallic material that reflects `diffuse` and, head on, `specular` [both linear] as nearly as one can: metals have no diffuse part, and
/// others reflect about 4 % at their boundary.
BaseAndMetallic metallic_of_specular(const glm::vec3& diffuse, const glm::vec3& specular);

}  // namespace pencil
