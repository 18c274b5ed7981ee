// Layers of light from the unit that an image was made in to that of the scene.
#pragma once

#include <string>
#include <vector>

#include "options/layer.h"

namespace pencil {

/// Multiplies all layers that hold light by a power of two, the variance by its square; albedo, normals and places stay. What leaves the range of
/// float on its way becomes its largest number, or is rounded; values that are not finite stay so. A sentence for each layer with such
/// values.
std::vector<std::string> scale_light(double unit, std::vector<Layer>& layers);

}  // namespace pencil
