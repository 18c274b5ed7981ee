// The place of an image in a sequence of images whose mean is the result, or that it is the only one.
#pragma once

#include <cstdint>

namespace pencil {

/// Images of one seed continue each other's sample sequences from turn to turn.
struct Turn {
    std::uint64_t seed = 0;   // of the sequence
    std::uint64_t index = 0;  // of the image
    bool alone = false;       // no mean follows: the best that one image can be
};

}  // namespace pencil
