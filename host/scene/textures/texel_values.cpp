#include "scene/textures/texel_values.h"

#include <algorithm>
#include <cmath>

namespace pencil {
namespace {

float linear_value(float value, double gamma) {
    if (gamma == 1) return value;
    if (gamma != 0) return std::pow(std::max(value, 0.0F), static_cast<float>(gamma));
    return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);  // IEC 61966-2-1
}

float channel_of(const glm::vec4& texel, TextureUse::Channel channel) {
    switch (channel) {
        case TextureUse::Channel::red:
            return texel.x;
        case TextureUse::Channel::green:
            return texel.y;
        case TextureUse::Channel::blue:
            return texel.z;
        case TextureUse::Channel::opacity:
            return texel.w;
        default:
            return 0.212671F * texel.x + 0.715160F * texel.y + 0.072169F * texel.z;  // luminance of linear sRGB
    }
}

}  // namespace

TexelValues::TexelValues(const DecodedImage& image, const TextureUse& use) : use_(use), is_encoded_(image.is_encoded) {
    if (!image.is_encoded || !image.is_bytes) return;
    for (int i = 0; i < 256; ++i) of_byte_.push_back(linear_value(static_cast<float>(i) / 255.0F, use.gamma));
}

float TexelValues::decoded(float value) const {
    if (of_byte_.empty()) return linear_value(value, use_.gamma);
    return of_byte_[static_cast<std::size_t>(std::clamp(value * 255.0F + 0.5F, 0.0F, 255.0F))];
}

glm::vec4 TexelValues::linear(glm::vec4 texel) const {
    if (is_encoded_)
        for (int i = 0; i < 3; ++i) texel[i] = decoded(texel[i]);
    if (use_.channel != TextureUse::Channel::all) texel = glm::vec4(glm::vec3(channel_of(texel, use_.channel)), texel.w);
    for (int i = 0; i < 4; ++i) texel[i] = std::isfinite(texel[i]) ? texel[i] : 0.0F;
    return texel;
}

}  // namespace pencil
