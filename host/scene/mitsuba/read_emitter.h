// Mitsuba's emitters: point lights, and the area emitters inside shapes.
#pragma once

#include "scene/mitsuba/properties.h"
#include "scene/scene.h"

namespace pencil {

/// Of an emitter that stands directly inside <scene>.
PointLight read_point_light(XmlSource& source, pugi::xml_node node);

/// Radiance of an emitter inside a shape [W m^-2 sr^-1].
glm::vec3 read_radiance(XmlSource& source, const NestedObject& object);

}  // namespace pencil
