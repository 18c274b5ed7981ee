// Indirect light by line projection, the thesis' method: one pencil set after the other, each projected to the film (thesis alg. 6.4).
#pragma once

#include "film/frame.h"

namespace pencil {

/// Adds reflections from order 2 on (from 1 where maps carry emitters) to the frame until the series has converged or enough bounces are
/// made, and closes it by its tail.
void add_line_bounces(RenderContext& context, Frame& frame);

}  // namespace pencil
