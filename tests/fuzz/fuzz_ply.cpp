// Any bytes as PLY: an error that names the place, or a mesh whose indices and numbers are sound.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/check_mesh.h"
#include "scene/meshes/read_ply.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    pencil::fuzz::accept_scene_errors([&] { pencil::fuzz::check_mesh(pencil::read_ply(bytes, "input.ply")); });
    return 0;
}
