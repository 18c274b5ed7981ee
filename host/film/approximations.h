// What of a scene a render does not show as its file says, in plain sentences.
#pragma once

#include <string>
#include <vector>

#include "film/method.h"
#include "scene/scene.h"

namespace pencil {

/// One sentence for each thing that is approximated by the kernels, beside what the reader of the file has said.
std::vector<std::string> approximations(const Scene& scene, const MethodNeeds& needs);

}  // namespace pencil
