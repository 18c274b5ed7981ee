// Formats that are known by what they begin with, but have no reader. `head`: the first kilobytes of a file, any bytes.
#pragma once

#include <string_view>

namespace pencil {

/// As text or in binary; the latter by the lengths of its normals, since it has no signature.
bool is_stl(std::string_view head);
/// As text (.usda), as a "crate" (.usdc) or zipped (.usdz).
bool is_usd(std::string_view head);
/// In binary or as text.
bool is_fbx(std::string_view head);
bool is_collada(std::string_view head);
/// In an Ogawa or an HDF5 archive.
bool is_alembic(std::string_view head);
bool is_blender(std::string_view head);
bool is_pbrt(std::string_view head);
bool is_png(std::string_view head);
bool is_exr(std::string_view head);
bool is_hdr(std::string_view head);

}  // namespace pencil
