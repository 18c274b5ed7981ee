// CIE 1976 L*a*b* of displayed colours, and the exposure they are displayed with.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>

namespace pencil {

/// Linear sRGB in [0, 1] to L*, a*, b* (CIE 15:2004, 8.2.1.1), white point D65: (1, 1, 1) has L* 100, a* 0, b* 0.
glm::dvec3 linear_srgb_to_lab(const glm::dvec3& rgb);

/// Factor that brings the median luminance of the pixels above 0 to the middle grey 0.18; 1 if there is none. `rgb`: 3 floats per pixel,
/// pixels with values that are not finite do not count.
double exposure_of(const float* rgb, std::size_t pixels);

}  // namespace pencil
