// What the first surfaces of some samples of a pixel look like.
#pragma once

#include <glm/glm.hpp>

namespace pencil {

/// Each times its filter weight.
struct SurfaceSums {
    glm::vec3 albedo{0.0F}, normal{0.0F}, position{0.0F};  // position [scene units]
    float weight = 0;
};

}  // namespace pencil
