#include "scene/mitsuba/read_emitter.h"

namespace pencil {
namespace {

/// Parameters that all emitters have, after their own.
void finish_emitter(Properties& p) {
    if (!p.objects().empty()) p.fail_nested(p.objects()[0]);
    p.ignore({"sampling_weight"});
    p.finish();
}

}  // namespace

PointLight read_point_light(XmlSource& source, pugi::xml_node node) {
    Properties p(source, node);
    const std::string type = node.attribute("type").value();
    if (type == "area") source.fail(node, p.label() + " must stand inside the shape that emits");
    if (type != "point") source.fail(node, p.label() + " is not supported; supported: point, and area inside a shape");
    if (p.has("position") && p.has("to_world")) p.fail("position", "give either position or to_world, not both");
    PointLight light;
    light.position = p.vector("position", glm::dvec3(p.transform("to_world")[3]));
    light.intensity = p.colour("intensity", glm::vec3(1.0F), ColourUse::emission);
    finish_emitter(p);
    return light;
}

glm::vec3 read_radiance(XmlSource& source, const NestedObject& object) {
    Properties p(source, object.node);
    if (object.type != "area") source.fail(object.named_at, p.label() + " cannot stand inside a shape; supported there: area");
    const glm::vec3 radiance = p.colour("radiance", glm::vec3(1.0F), ColourUse::emission);
    finish_emitter(p);
    return radiance;
}

}  // namespace pencil
