// Integrators that find the same light paths as "path" are read as it, with a warning; any other would show a different picture.
#include "scene/mitsuba/read_integrator.h"

#include <algorithm>
#include <limits>

namespace pencil {
namespace {

const std::vector<std::string> like_path = {"volpath", "volpathmis", "volpath_simple", "bdpt", "ptracer", "mlt",
                                            "pssmlt",  "erpt",       "photonmapper",   "ppm",  "sppm",    "vpl",
                                            "prb",     "prb_basic",  "prbvolpath"};

}  // namespace

int read_max_depth(XmlSource& source, pugi::xml_node node) {
    Properties p(source, node);
    const std::string type = node.attribute("type").value();
    const bool stands_in = std::find(like_path.begin(), like_path.end(), type) != like_path.end();
    if (type != "path" && type != "direct" && !stands_in)
        p.fail("", "is not supported; supported: path, direct (others of the path family are read as path)");
    if (stands_in) source.warn(node, p.label() + " is read as \"path\": the same light paths, solved by this program's own method");
    if (!p.objects().empty()) p.fail_nested(p.objects()[0]);
    const long long depth = p.integer("max_depth", -1);
    if (depth != -1 && (depth < 1 || depth > std::numeric_limits<int>::max()))
        p.fail("max_depth", "max_depth must be -1 (no limit) or at least 1 (emission only)");
    if (p.boolean("hide_emitters", false)) source.warn(node, p.label() + ": hide_emitters is not supported, emitters are shown");
    p.ignore({"rr_depth", "strict_normals"});
    if (type == "path") p.finish();  // the others' parameters steer algorithms that are not used here
    return type == "direct" ? 2 : static_cast<int>(depth);
}

}  // namespace pencil
