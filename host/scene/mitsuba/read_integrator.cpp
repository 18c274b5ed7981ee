// Integrators of one light path are read as "path"; what others would show beside light is left out with a warning.
#include "scene/mitsuba/read_integrator.h"

#include <algorithm>
#include <limits>

#include "scene/text.h"

namespace pencil {
namespace {

constexpr int deepest_integrator = 4;  // integrators inside integrators

const std::vector<std::string> like_path = {"volpath", "volpathmis", "volpath_simple", "bdpt", "ptracer", "mlt",
                                            "pssmlt",  "erpt",       "photonmapper",   "ppm",  "sppm",    "vpl",
                                            "prb",     "prb_basic",  "prbvolpath"};

/// -1 for what is no limit, or no sensible one.
int bounces(Properties& p) {
    const long long depth = p.integer("max_depth", -1);
    if (depth == -1) return -1;
    if (depth < 1 || depth > std::numeric_limits<int>::max())
        p.fail("max_depth", "max_depth must be -1 (no limit) or at least 1 (emission only)");
    return static_cast<int>(depth);
}

int read(XmlSource& source, pugi::xml_node node, int depth) {
    Properties p(source, node);
    const std::string type = node.attribute("type").value();
    if (depth > deepest_integrator) p.fail("", "holds integrators in each other too deep");
    const std::vector<NestedObject> inner = p.take_objects("integrator");
    if (!inner.empty()) {  // moment, aov, stereo, adaptive, irrcache ...
        source.warn(node, p.label() + ": what it adds is left out, the integrator inside is read");
        return read(source, inner[0].node, depth + 1);
    }
    const bool stands_in = std::find(like_path.begin(), like_path.end(), type) != like_path.end();
    if (stands_in)
        source.warn(node, p.label() + " is read as \"path\": the same light paths, solved by this program's own method");
    else if (type != "path" && type != "direct" && !source.is_undefined(node))
        p.approximate("", "is not supported: read as \"path\"");
    const int limit = bounces(p);
    if (p.boolean("hide_emitters", false)) p.approximate("hide_emitters", "hide_emitters is not supported, emitters are shown");
    p.ignore({"rr_depth", "strict_normals"});
    if (type == "path") p.finish();  // the others' parameters steer algorithms that are not used here
    return type == "direct" ? 2 : limit;
}

}  // namespace

int read_max_depth(XmlSource& source, pugi::xml_node node) { return read(source, node, 0); }

}  // namespace pencil
