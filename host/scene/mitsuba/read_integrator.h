// Of Mitsuba's integrators only the number of bounces is taken: how they are computed is this program's own matter.
#pragma once

#include "scene/mitsuba/properties.h"

namespace pencil {

/// 1: emission only, 2: plus direct light, -1: no limit.
int read_max_depth(XmlSource& source, pugi::xml_node node);

}  // namespace pencil
