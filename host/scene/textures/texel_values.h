// The numbers of pictures, made linear.
#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "scene/textures/add_texture.h"
#include "scene/textures/decode_image.h"

namespace pencil {

/// Texels of one picture as stored, to linear sRGB with the channel asked for. What is not finite is zero.
class TexelValues {
public:
    TexelValues(const DecodedImage& image, const TextureUse& use);

    glm::vec4 linear(glm::vec4 texel) const;

private:
    float decoded(float value) const;

    TextureUse use_;
    bool is_encoded_;
    std::vector<float> of_byte_;  // decoded values of 0 to 255, for pictures of bytes
};

}  // namespace pencil
