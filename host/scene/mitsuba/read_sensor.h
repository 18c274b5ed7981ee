// Mitsuba's sensors that take pictures: perspective, thinlens and orthographic.
#pragma once

#include "scene/mitsuba/properties.h"
#include "scene/scene.h"

namespace pencil {

/// False for those that measure without an image, and unknown ones.
bool takes_pictures(const std::string& type);

PerspectiveSensor read_sensor(XmlSource& source, pugi::xml_node node);

/// Of a scene that has none: sees all of it along +z, as Mitsuba's. The scene has triangles.
PerspectiveSensor default_sensor(const Scene& scene);

}  // namespace pencil
