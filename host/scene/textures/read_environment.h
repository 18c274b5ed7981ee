// Maps of the light from all around.
#pragma once

#include <filesystem>
#include <string>

#include "scene/scene.h"
#include "scene/textures/add_texture.h"

namespace pencil {

/// Fills size and texels of `environment` from a picture of latitude and longitude. SceneError at `where` as by decode_image_file.
void read_environment(const std::filesystem::path& file, const TextureUse& use, const std::string& where, Environment& environment);

}  // namespace pencil
