// Mitsuba's own mesh files (.serialized, versions 3 and 4): several meshes, each packed by zlib.
#pragma once

#include <string>
#include <string_view>

#include "scene/meshes/mesh.h"

namespace pencil {

/// Mesh number `index`; `name` is the file's name for messages.
Mesh read_serialized(std::string_view bytes, std::size_t index, const std::string& name);

}  // namespace pencil
