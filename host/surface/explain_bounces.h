// How the world's bounces were added up, in words.
#pragma once

#include <string>

#include "options/render_result.h"

namespace pencil {

std::string explain_bounces(const BounceSolve& solve, double residual);

/// The warning where their sum lacks something, and what helps.
std::string unfinished_bounces(const BounceSolve& solve, double residual);

}  // namespace pencil
