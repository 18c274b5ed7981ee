// Environments and textures for tests of the path tracer.
#pragma once

#include <glm/gtc/packing.hpp>

#include "reference/random.h"
#include "scene/scene.h"

namespace pencil::test {

/// One value a texel, opacity 1/2.
inline Texture bitmap(int width, int height, const std::vector<float>& values) {
    Texture texture;
    texture.width = width;
    texture.height = height;
    for (const float v : values)
        texture.texels.push_back({glm::packHalf1x16(v), glm::packHalf1x16(v), glm::packHalf1x16(v), glm::packHalf1x16(0.5F)});
    return texture;
}

/// Frame whose +z is `forward`.
inline glm::dmat3 towards(const glm::dvec3& forward) {
    const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(0.3, 1, 0.2), forward));
    return {x, glm::cross(forward, x), forward};
}

/// Of few texels, one of them black and one bright.
inline Environment random_map() {
    ref::Random random(5);
    Environment map;
    map.width = 9;
    map.height = 6;
    for (int i = 0; i < 54; ++i) map.texels.push_back(glm::vec3(static_cast<float>(std::pow(random.uniform(), 4))));
    map.texels[13] = glm::vec3(0.0F);
    map.texels[22] = glm::vec3(40.0F);
    map.to_world = towards(glm::normalize(glm::dvec3(1, 2, -0.5)));
    return map;
}

}  // namespace pencil::test
