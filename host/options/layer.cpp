#include "options/layer.h"

#include <fmt/format.h>

#include <algorithm>

namespace pencil {

const std::vector<std::string>& layer_groups() {
    static const std::vector<std::string> groups = [] {
        std::vector<std::string> all = light_groups();
        all.insert(all.end(), surface_groups().begin(), surface_groups().end());
        return all;
    }();
    return groups;
}

const std::vector<std::string>& light_groups() {
    static const std::vector<std::string> groups{emission_layer, direct_layer, bounces_group};
    return groups;
}

const std::vector<std::string>& surface_groups() {
    static const std::vector<std::string> groups{albedo_layer, normal_layer, depth_layer, position_layer};
    return groups;
}

const std::vector<std::string>& photometric_layers() {
    static const std::vector<std::string> layers{illuminance_layer, luminance_layer};
    return layers;
}

bool has_photometric(const std::vector<std::string>& layers) {
    return has_group(layers, illuminance_layer) || has_group(layers, luminance_layer);
}

std::string bounce_layer(int order) { return order == 1 ? direct_layer : fmt::format("bounce{}", order); }

std::string tail_layer(int first_order) { return fmt::format("tail{}", first_order); }

bool is_bounce(const std::string& name) { return name.rfind("bounce", 0) == 0 || name.rfind("tail", 0) == 0; }

bool has_group(const std::vector<std::string>& groups, const std::string& group) {
    return std::find(groups.begin(), groups.end(), group) != groups.end();
}

}  // namespace pencil
