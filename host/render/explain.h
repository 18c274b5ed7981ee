// Decisions of a render in plain sentences, for --explain: what was chosen and why, and what the scene does not need. Here is what is the
// same for all methods; each method explains itself.
#pragma once

#include <string>
#include <vector>

#include "film/render_context.h"

namespace pencil {

std::vector<std::string> explain(const RenderContext& context);

}  // namespace pencil
