// Linear sRGB as one number.
#pragma once

#include <glm/vec3.hpp>

namespace pencil {

/// Rec. 709 luminance of linear sRGB.
inline double luminance(const glm::dvec3& rgb) { return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z; }

}  // namespace pencil
