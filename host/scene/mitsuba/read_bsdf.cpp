// A twosided material takes the name of its own element, or else that of the material inside.
#include "scene/mitsuba/read_bsdf.h"

namespace pencil {
namespace {

constexpr int deepest = 4;  // twosided holds one diffuse; a chain longer than this is a circle of references

SceneMaterial read_nested(XmlSource& source, pugi::xml_node node, int depth) {
    Properties p(source, node);
    const std::string type = node.attribute("type").value();
    SceneMaterial result;
    if (type == "diffuse") {
        const char* name = p.has("diffuse_reflectance") ? "diffuse_reflectance" : "reflectance";  // the former is an alias in Mitsuba 0.x
        result.albedo = p.colour(name, glm::vec3(0.5F), ColourUse::reflectance);
        if (!p.objects().empty()) p.fail_nested(p.objects()[0]);
    } else if (type == "twosided") {
        if (depth > deepest) p.fail("", "refers to itself");
        if (p.objects().size() != 1 || p.objects()[0].kind != "bsdf") p.fail("", "needs exactly one nested bsdf");
        const NestedObject& inner = p.objects()[0];
        if (inner.type == "twosided" && inner.node != node) source.fail(inner.named_at, p.label() + " cannot hold another twosided");
        result = read_nested(source, inner.node, depth + 1);
        result.two_sided = true;
    } else {
        p.fail("", "is not supported; supported: diffuse, twosided");
    }
    if (node.attribute("id")) result.id = node.attribute("id").value();
    p.finish();
    return result;
}

}  // namespace

SceneMaterial read_bsdf(XmlSource& source, pugi::xml_node node) { return read_nested(source, node, 0); }

}  // namespace pencil
