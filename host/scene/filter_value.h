// The reconstruction filters of Mitsuba, as functions of one axis.
#pragma once

#include "scene/scene.h"

namespace pencil {

/// Value of the (separable, unnormalised) filter at distance x from the pixel centre along one axis [pixels].
double filter_value(const ReconstructionFilter& filter, double x);

}  // namespace pencil
