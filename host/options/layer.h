// One image of a result that has several, and names that more than one writer gives.
#pragma once

#include <string>
#include <vector>

namespace pencil {

/// One image: `channels` floats per pixel, rows from the top.
struct Layer {
    std::string name;  // "" is the beauty; otherwise "direct", "bounce2", "albedo", "normal", "depth", "position" ...
    int channels = 3;
    std::vector<float> pixels;
};

/// Name of the sum of reflection `first_order` and all further ones: "tail16". Two images pair layers by name, and by this name only those
/// that hold the same orders.
inline std::string tail_name(int first_order) { return "tail" + std::to_string(first_order); }

/// Whether the layer is a reflection from the second on, or a sum of them: "bounce2", "tail16".
inline bool is_bounce(const std::string& name) { return name.rfind("bounce", 0) == 0 || name.rfind("tail", 0) == 0; }

}  // namespace pencil
