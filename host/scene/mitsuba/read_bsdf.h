// Mitsuba's materials, as far as this program knows them: diffuse, and twosided around it.
#pragma once

#include "scene/mitsuba/properties.h"
#include "scene/scene.h"

namespace pencil {

SceneMaterial read_bsdf(XmlSource& source, pugi::xml_node node);

}  // namespace pencil
