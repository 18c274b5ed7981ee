// At 589.29 nm; gases at standard conditions. Hecht, Optics (2002), and common tables; the values that Mitsuba uses.
#include "scene/mitsuba/refraction_index.h"

#include <map>

namespace pencil {
namespace {

const std::map<std::string, double> indices = {{"vacuum", 1.0},      {"helium", 1.000036},        {"hydrogen", 1.000132},
                                               {"air", 1.000277},    {"carbon dioxide", 1.00045}, {"water", 1.333},
                                               {"acetone", 1.36},    {"ethanol", 1.361},          {"carbon tetrachloride", 1.461},
                                               {"glycerol", 1.4729}, {"benzene", 1.501},          {"silicone oil", 1.52045},
                                               {"bromine", 1.661},   {"water ice", 1.31},         {"fused quartz", 1.458},
                                               {"pyrex", 1.47},      {"acrylic glass", 1.49},     {"polypropylene", 1.49},
                                               {"bk7", 1.5046},      {"sodium chloride", 1.544},  {"amber", 1.55},
                                               {"pet", 1.575},       {"diamond", 2.419}};

}  // namespace

std::optional<double> refraction_index(const std::string& name) {
    const auto place = indices.find(name);
    return place == indices.end() ? std::nullopt : std::optional<double>(place->second);
}

std::vector<std::string> refraction_names() {
    std::vector<std::string> names;
    names.reserve(indices.size());
    for (const auto& row : indices) names.push_back(row.first);
    return names;
}

}  // namespace pencil
