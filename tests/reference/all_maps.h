// All map parameterisations that are compared, with what the device needs to build theirs.
#pragma once

#include <vector>

#include "reference/cube_ref.h"
#include "reference/paraboloid_ref.h"
#include "reference/pyramid_ref.h"
#include "reference/superquadric_ref.h"

namespace pencil::ref {

struct NamedMap {
    Map map;
    std::string prefix;    // of its functions in kernels/lib/<prefix>.cl
    std::string exponent;  // PENCIL_SUPERQUADRIC_EXPONENT, empty for other maps
    bool cone = false;     // PENCIL_SUPERQUADRIC_CONE
};

inline void PrintTo(const NamedMap& named, std::ostream* out) { PrintTo(named.map, out); }

/// Those that renders have, at the places of their numbers in shared/map_kind.h.
inline std::vector<Map> render_maps() { return {octahedral_map(), pyramid_map(), cube_map(), paraboloid_map()}; }

inline std::vector<NamedMap> comparison_maps() {
    std::vector<NamedMap> maps = {{paraboloid_map(), "paraboloid", ""}, {cube_map(), "cube", ""}, {pyramid_map(), "pyramid", ""}};
    const double no_limit = std::numeric_limits<double>::infinity();
    for (const bool cone : {false, true})
        for (const auto& [p, text] : {std::pair(1.0, "1.0f"), std::pair(1.5, "1.5f"), std::pair(2.0, "2.0f"), std::pair(4.0, "4.0f"),
                                      std::pair(no_limit, "INFINITY")})
            maps.push_back({superquadric_map(p, cone), "superquadric", text, cone});
    return maps;
}

}  // namespace pencil::ref
