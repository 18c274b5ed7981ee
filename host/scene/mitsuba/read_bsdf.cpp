// A twosided material takes the name of its own element, or else that of the material inside.
#include "scene/mitsuba/read_bsdf.h"

#include <map>

namespace pencil {
namespace {

constexpr int deepest = 4;  // twosided holds one material; a chain longer than this is a circle of references

SceneMaterial read_diffuse(Properties& p) {
    SceneMaterial result;
    const char* name = p.has("diffuse_reflectance") ? "diffuse_reflectance" : "reflectance";  // the former is an alias in Mitsuba 0.x
    result.albedo = p.colour(name, glm::vec3(0.5F), ColourUse::reflectance);
    if (!p.objects().empty()) p.fail_nested(p.objects()[0]);
    return result;
}

/// Plugins by their names; a new one is a row.
const std::map<std::string, SceneMaterial (*)(Properties&)> readers{{"diffuse", read_diffuse}};

std::string known_plugins() {
    std::string names;
    for (const auto& row : readers) names += row.first + ", ";
    return names + "twosided";
}

SceneMaterial read_nested(XmlSource& source, pugi::xml_node node, int depth);

SceneMaterial read_twosided(XmlSource& source, pugi::xml_node node, Properties& p, int depth) {
    if (depth > deepest) p.fail("", "refers to itself");
    if (p.objects().size() != 1 || p.objects()[0].kind != "bsdf") p.fail("", "needs exactly one nested bsdf");
    const NestedObject& inner = p.objects()[0];
    if (inner.type == "twosided" && inner.node != node) source.fail(inner.named_at, p.label() + " cannot hold another twosided");
    SceneMaterial result = read_nested(source, inner.node, depth + 1);
    result.two_sided = true;
    return result;
}

SceneMaterial read_nested(XmlSource& source, pugi::xml_node node, int depth) {
    Properties p(source, node);
    const std::string type = node.attribute("type").value();
    const auto reader = readers.find(type);
    if (reader == readers.end() && type != "twosided") p.fail("", "is not supported; supported: " + known_plugins());
    SceneMaterial result = type == "twosided" ? read_twosided(source, node, p, depth) : reader->second(p);
    if (node.attribute("id")) result.id = node.attribute("id").value();
    p.finish();
    return result;
}

}  // namespace

SceneMaterial read_bsdf(XmlSource& source, pugi::xml_node node) { return read_nested(source, node, 0); }

}  // namespace pencil
