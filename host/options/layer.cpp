#include "options/layer.h"

#include <algorithm>

namespace pencil {

const std::vector<std::string>& layer_groups() {
    static const std::vector<std::string> groups{"emission", "direct", "bounces", "albedo", "normal", "depth", "position"};
    return groups;
}

std::string bounce_layer(int order) { return order == 1 ? "direct" : "bounce" + std::to_string(order); }

bool has_group(const std::vector<std::string>& groups, const std::string& group) {
    return std::find(groups.begin(), groups.end(), group) != groups.end();
}

}  // namespace pencil
