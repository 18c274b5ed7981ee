// How a Mitsuba texture is laid over a surface, and how the numbers of its file are meant.
#pragma once

#include "scene/mitsuba/properties.h"
#include "scene/textures/add_texture.h"

namespace pencil {

/// "to_uv" (2, 3), or scale and offset (0.x).
glm::dmat3 read_to_uv(Properties& p);
/// That, the filter and the wrap modes.
TextureSampling read_sampling(Properties& p);
/// "raw" (2, 3) or "gamma" (0.x); `channel` unless the texture names one itself.
TextureUse read_use(Properties& p, TextureUse::Channel channel);

}  // namespace pencil
