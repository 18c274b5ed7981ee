// A short name for what a scene is, to tell whether two images can be compared.
#pragma once

#include <string>

#include "scene/scene.h"

namespace pencil {

/// 16 hexadecimal digits that depend on geometry, materials, lights, camera and pixel filter. Names, the size of the image and max_depth
/// do not enter: options replace them. Equal on all machines of one byte order.
std::string scene_fingerprint(const Scene& scene);

}  // namespace pencil
