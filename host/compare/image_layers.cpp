#include "compare/image_layers.h"

#include <algorithm>

#include "image/write_image.h"
#include "options/layer.h"

namespace pencil {
namespace {

struct Group {
    std::string name;
    std::vector<std::string> channels;
    std::vector<std::size_t> indices;  // in the image
};

/// Sorts by R, G, B, A and X, Y, Z: OpenEXR stores channels by name.
int rank(const std::string& channel) {
    const std::size_t found = std::string("RGBAXYZ").find(channel);
    return channel.size() == 1 && found != std::string::npos ? static_cast<int>(found) : -1;
}

std::vector<Group> group_channels(const std::vector<std::string>& names) {
    std::vector<Group> groups;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::size_t dot = names[i].rfind('.');
        const std::string name = dot == std::string::npos ? "beauty" : names[i].substr(0, dot);
        auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.name == name; });
        if (group == groups.end()) group = groups.insert(name == "beauty" ? groups.begin() : groups.end(), Group{name, {}, {}});
        group->channels.push_back(dot == std::string::npos ? names[i] : names[i].substr(dot + 1));
        group->indices.push_back(i);
    }
    return groups;
}

/// Positions within the group in the order wanted, without alpha.
std::vector<std::size_t> ordered(const Group& group) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < group.channels.size(); ++i)
        if (group.channels[i] != "A" || group.channels.size() == 1) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return rank(group.channels[a]) < rank(group.channels[b]); });
    return order;
}

NamedLayer extract(const Image& image, const Group& group) {
    NamedLayer layer;
    layer.name = group.name;
    const std::vector<std::size_t> order = ordered(group);
    for (const std::size_t position : order) layer.channels.push_back(group.channels[position]);
    const std::size_t stride = image.channels.size();
    layer.pixels.reserve(image.pixels.size() / stride * order.size());
    for (std::size_t pixel = 0; pixel < image.pixels.size(); pixel += stride) {
        for (const std::size_t position : order) {
            const float value = image.pixels[pixel + group.indices[position]];
            layer.pixels.push_back(image.display ? srgb_to_linear(value) : value);
        }
    }
    return layer;
}

}  // namespace

std::vector<NamedLayer> split_layers(const Image& image) {
    const std::vector<Group> groups = group_channels(image.channels);
    std::vector<NamedLayer> layers(groups.size());
    std::transform(groups.begin(), groups.end(), layers.begin(), [&](const Group& group) { return extract(image, group); });
    return layers;
}

std::vector<float> select_channels(const NamedLayer& layer, const std::vector<std::string>& wanted) {
    if (wanted == layer.channels) return layer.pixels;
    std::vector<std::size_t> positions;
    positions.reserve(wanted.size());
    for (const std::string& channel : wanted) {
        positions.push_back(
            static_cast<std::size_t>(std::find(layer.channels.begin(), layer.channels.end(), channel) - layer.channels.begin()));
    }
    std::vector<float> pixels;
    pixels.reserve(layer.pixels.size() / layer.channels.size() * wanted.size());
    for (std::size_t pixel = 0; pixel < layer.pixels.size(); pixel += layer.channels.size())
        for (const std::size_t position : positions) pixels.push_back(layer.pixels[pixel + position]);
    return pixels;
}

bool is_light(const std::string& name) {
    return name == "beauty" || name == emission_layer || name == direct_layer || name == indirect_layer || is_bounce(name);
}

}  // namespace pencil
