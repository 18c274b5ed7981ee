#include "compare/compare_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/image_layers.h"
#include "compare/lab.h"
#include "util/error.h"
#include "util/format.h"

namespace pencil {
namespace {

using Metadata = std::map<std::string, std::string>;

const NamedLayer* find_layer(const std::vector<NamedLayer>& layers, const std::string& name) {
    const auto found = std::find_if(layers.begin(), layers.end(), [&](const NamedLayer& layer) { return layer.name == name; });
    return found == layers.end() ? nullptr : &*found;
}

std::vector<std::string> common_channels(const NamedLayer& a, const NamedLayer& b) {
    std::vector<std::string> common;
    std::copy_if(a.channels.begin(), a.channels.end(), std::back_inserter(common),
                 [&](const std::string& channel) { return std::find(b.channels.begin(), b.channels.end(), channel) != b.channels.end(); });
    return common;
}

bool is_rgb(const std::vector<std::string>& channels) { return channels == std::vector<std::string>{"R", "G", "B"}; }

NonFinite first_non_finite(const std::vector<float>& pixels, const std::vector<std::string>& channels, int width) {
    NonFinite found;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (std::isfinite(pixels[i]) || found.values++ > 0) {
            continue;
        }
        const std::size_t pixel = i / channels.size();
        found.channel = channels[i % channels.size()];
        found.x = static_cast<int>(pixel % static_cast<std::size_t>(width));
        found.y = static_cast<int>(pixel / static_cast<std::size_t>(width));
    }
    return found;
}

LayerComparison compare_layer(const NamedLayer& image, const NamedLayer& reference, const std::vector<std::string>& channels, int width,
                              double exposure) {
    const std::vector<float> x = select_channels(image, channels), r = select_channels(reference, channels);
    const PixelPair pair{x.data(), r.data(), x.size() / channels.size(), static_cast<int>(channels.size())};
    LayerComparison result{image.name, channels, {}, first_non_finite(x, channels, width), first_non_finite(r, channels, width)};
    const bool shown = is_light(image.name) && is_rgb(channels);
    result.metrics = measure(pair, shown ? std::optional<double>(exposure) : std::nullopt);
    return result;
}

std::string value_or(const Metadata& metadata, const std::string& key, const std::string& absent) {
    const auto found = metadata.find(key);
    return found == metadata.end() ? absent : found->second;
}

/// Fingerprints decide, names only where one is missing. Files of other programs have neither.
std::vector<std::string> scene_warnings(const Metadata& image, const Metadata& reference) {
    for (const char* key : {"pencil:sceneFingerprint", "pencil:scene"}) {
        const auto a = image.find(key), b = reference.find(key);
        if (a == image.end() || b == reference.end()) {
            continue;
        }
        if (a->second == b->second) {
            return {};
        }
        return {fmt::format("the images show different scenes: {} and {} ({} is {} and {})", value_or(image, "pencil:scene", "?"),
                            value_or(reference, "pencil:scene", "?"), key, a->second, b->second)};
    }
    return {};
}

}  // namespace

Comparison compare_images(const Image& image, const Image& reference, const std::string& image_name, const std::string& reference_name) {
    if (image.width != reference.width || image.height != reference.height) {
        throw SceneError(image_name, fmt::format("has {} pixels, the reference {} has {}; render both with the same --resolution",
                                                 format_extent(image.width, image.height), reference_name,
                                                 format_extent(reference.width, reference.height)));
    }
    const std::vector<NamedLayer> ours = split_layers(image), theirs = split_layers(reference);
    Comparison result{image.width, image.height, 1, {}, {}, {}, scene_warnings(image.metadata, reference.metadata)};
    for (const auto& [name, picture] : {std::pair(&image_name, &image), std::pair(&reference_name, &reference)}) {
        if (picture->metadata.count("pencil:interrupted") > 0) {
            result.warnings.push_back(fmt::format("{} is the unfinished image of an interrupted render", *name));
        }
    }
    const NamedLayer* beauty = find_layer(theirs, "beauty");
    if (beauty != nullptr && is_rgb(beauty->channels)) {
        result.exposure = exposure_of(beauty->pixels.data(), beauty->pixels.size() / 3);
    }
    for (const NamedLayer& layer : ours) {
        const NamedLayer* other = find_layer(theirs, layer.name);
        const std::vector<std::string> channels = other == nullptr ? std::vector<std::string>{} : common_channels(layer, *other);
        if (channels.empty()) {
            result.only_in_image.push_back(layer.name);
        } else {
            result.layers.push_back(compare_layer(layer, *other, channels, image.width, result.exposure));
        }
    }
    for (const NamedLayer& layer : theirs) {
        const NamedLayer* other = find_layer(ours, layer.name);
        if (other == nullptr || common_channels(*other, layer).empty()) {
            result.only_in_reference.push_back(layer.name);
        }
    }
    if (result.layers.empty()) {
        throw SceneError(image_name, fmt::format("has no layer in common with the reference {}", reference_name));
    }
    return result;
}

}  // namespace pencil
