// One image of a result that has several.
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

}  // namespace pencil
