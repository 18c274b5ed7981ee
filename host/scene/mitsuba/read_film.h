// Mitsuba's films and their reconstruction filters.
#pragma once

#include "scene/mitsuba/properties.h"
#include "scene/scene.h"

namespace pencil {

/// Fills size, crop window and filter of the sensor.
void read_film(XmlSource& source, const NestedObject& object, PerspectiveSensor& sensor);

}  // namespace pencil
