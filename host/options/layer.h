// The layers of an image: their names, once for everyone who makes, writes or compares them.
#pragma once

#include <string>
#include <vector>

#include "util/archive.h"

namespace pencil {

/// One layer; rows from the top, channels interleaved.
struct Layer {
    std::string name;  // "" is the beauty; otherwise "direct", "bounce2", "albedo", "normal", "depth", "position" ...
    int channels = 3;
    std::vector<float> pixels;

    void transfer(Archive& archive) { archive(name, channels, pixels); }
};

constexpr const char* emission_layer = "emission";
constexpr const char* direct_layer = "direct";
constexpr const char* albedo_layer = "albedo";
constexpr const char* normal_layer = "normal";
constexpr const char* depth_layer = "depth";
constexpr const char* position_layer = "position";
/// Not a layer, but all of them that bounce_layer names from order 2 on, indirect_layer, and the tail of the series.
constexpr const char* bounces_group = "bounces";

/// Illuminance of what a pixel shows [lx], and luminance of the pixel [cd m^-2], one channel each. Made only where they are named.
constexpr const char* illuminance_layer = "illuminance";
constexpr const char* luminance_layer = "luminance";

/// What --aov chooses from, in the order of files: layers of light, then of surfaces.
const std::vector<std::string>& layer_groups();
const std::vector<std::string>& light_groups();
const std::vector<std::string>& surface_groups();
/// Beside those: illuminance and luminance.
const std::vector<std::string>& photometric_layers();
/// True if one of those is among `layers`.
bool has_photometric(const std::vector<std::string>& layers);

/// direct_layer for order 1, then "bounce2" and so on.
std::string bounce_layer(int order);

/// The sum of reflection `first_order` and all further ones: "tail16". Images pair layers by name, and this one only pairs those that hold
/// the same orders.
std::string tail_layer(int first_order);

/// Whether the layer is a reflection from order 2 on, or a sum of them: "bounce2", "tail16".
bool is_bounce(const std::string& name);

/// All reflections from order 2 on in one layer.
constexpr const char* indirect_layer = "indirect";
/// Estimated standard error of the beauty.
constexpr const char* error_layer = "error";
/// Estimated variance of the mean (path tracer).
constexpr const char* variance_layer = "variance";

/// True if `group` is among `groups`.
bool has_group(const std::vector<std::string>& groups, const std::string& group);

}  // namespace pencil
