// With m the metallic, f = 0.04 the reflectance of what is no metal, and a base colour b of brightness B:
//   specular S = f (1 - m) + B m,   diffuse D = B (1 - m) (1 - f) / (1 - s),   s the largest component of specular
// Without B this is f m^2 + (D (1 - s) / (1 - f) + S - 2 f) m + f - S = 0.
#include "scene/gltf/specular_glossiness.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pencil {
namespace {

constexpr float of_no_metal = 0.04F, tiny = 1e-4F;

/// As the eye weighs linear components, squared and so even for saturated colours.
float brightness(const glm::vec3& colour) {
    const glm::vec3 weights(0.299F, 0.587F, 0.114F);
    return std::sqrt(glm::dot(weights, colour * colour));
}

float metallic_of(float diffuse, float specular, float left) {
    if (specular <= of_no_metal) return 0;
    const float b = diffuse * left / (1 - of_no_metal) + specular - 2 * of_no_metal, c = of_no_metal - specular;
    return std::clamp((-b + std::sqrt(std::max(b * b - 4 * of_no_metal * c, 0.0F))) / (2 * of_no_metal), 0.0F, 1.0F);
}

}  // namespace

BaseAndMetallic metallic_of_specular(const glm::vec3& diffuse, const glm::vec3& specular) {
    const float left = 1 - std::clamp(std::max({specular.x, specular.y, specular.z}), 0.0F, 1.0F);
    BaseAndMetallic result;
    result.metallic = metallic_of(brightness(diffuse), brightness(specular), left);
    const float m = result.metallic;
    const glm::vec3 by_diffuse = diffuse * (left / (1 - of_no_metal) / std::max(1 - m, tiny));
    const glm::vec3 by_specular = (specular - of_no_metal * (1 - m)) / std::max(m, tiny);
    result.base = glm::clamp(glm::mix(by_diffuse, by_specular, m * m), glm::vec3(0.0F), glm::vec3(1.0F));
    return result;
}

}  // namespace pencil
