// Indirect light by pencils on surfaces: a world set for all bounces, film pencils that gather from it, and the film lit by them.
#pragma once

#include "transport/frame.h"
#include "transport/surface_solver.h"

namespace pencil {

/// Adds all reflections from order 2 on (from 1 where maps carry emitters) to the frame, as one layer "indirect".
void add_surface_bounces(RenderContext& context, const DeviceBvh& bvh, Frame& frame, std::uint64_t seed);

}  // namespace pencil
