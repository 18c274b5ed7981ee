// Mitsuba's perspective sensor and its film and reconstruction filter.
#pragma once

#include "scene/mitsuba/properties.h"
#include "scene/scene.h"

namespace pencil {

PerspectiveSensor read_sensor(XmlSource& source, pugi::xml_node node);

}  // namespace pencil
