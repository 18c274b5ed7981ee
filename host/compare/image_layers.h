// An image file taken apart into its layers, as linear values: what `compare` pairs up.
#pragma once

#include <string>
#include <vector>

#include "image/read_image.h"

namespace pencil {

struct NamedLayer {
    std::string name;                   // "beauty", "direct", "bounce2", "depth" ...
    std::vector<std::string> channels;  // last parts of the names: "R", "G", "B"; "X", "Y", "Z"; "Z"
    std::vector<float> pixels;          // channels interleaved
};

/// Groups channels by what stands before the last dot of their names; those without a dot are the beauty. Beauty first, the others in the
/// file's order. R, G, B and X, Y, Z stand in this order; alpha is left out beside other channels. Display values (PNG) become linear.
std::vector<NamedLayer> split_layers(const Image& image);

/// The channels `wanted` of a layer, in this order; each must exist.
std::vector<float> select_channels(const NamedLayer& layer, const std::vector<std::string>& wanted);

/// Whether the layer is radiance of the image: the beauty or a part of it.
bool is_light(const std::string& name);

}  // namespace pencil
