// Values of single elements: numbers, vectors, colours, transforms. Every defect names the element's line.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <pugixml.hpp>
#include <string>

#include "scene/mitsuba/xml_source.h"

namespace pencil {

/// coefficient: an index of refraction or extinction, grey if it is one number.
enum class ColourUse { reflectance, emission, coefficient };

double attribute_number(const XmlSource& source, pugi::xml_node node, const char* attribute);
/// value="x y z", value="s" for all three, or x=, y=, z=, each of which may be absent.
glm::dvec3 parse_vector(const XmlSource& source, pugi::xml_node node, double absent);
/// <float>, <rgb>, <srgb> or <spectrum> as linear sRGB, its range checked for the use.
glm::vec3 parse_colour(XmlSource& source, pugi::xml_node node, ColourUse use);
/// The operations inside a <transform>, the first applied first; affine and finite, but perhaps singular.
glm::dmat4 parse_transform(XmlSource& source, pugi::xml_node node);

}  // namespace pencil
