#include "scene/textures/read_environment.h"

#include <glm/common.hpp>

#include "scene/textures/decode_image.h"
#include "scene/textures/texel_values.h"

namespace pencil {

void read_environment(const std::filesystem::path& file, const TextureUse& use, const std::string& where, Environment& environment) {
    const DecodedImage image = decode_image_file(file, where);
    environment.width = image.width;
    environment.height = image.height;
    environment.texels.clear();
    environment.texels.reserve(image.texels.size());
    constexpr float brightest = 1e30F;  // sums stay finite
    const TexelValues values(image, use);
    for (const glm::vec4& texel : image.texels) environment.texels.push_back(glm::clamp(glm::vec3(values.linear(texel)), 0.0F, brightest));
}

}  // namespace pencil
