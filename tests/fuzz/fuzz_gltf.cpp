// Any bytes as glTF, text or binary: an error, or a scene whose indices and numbers are sound.
#include <cstddef>
#include <cstdint>
#include <string>

#include "fuzz/scene_folder.h"
#include "scene/gltf/read_gltf.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const pencil::fuzz::SceneFolder folder;
    const std::filesystem::path file = folder.path / "scene.gltf";
    pencil::fuzz::write_file(file, std::string(reinterpret_cast<const char*>(data), size));
    pencil::fuzz::accept_scene_errors([&] { pencil::fuzz::check_scene(pencil::read_gltf(file, {})); });
    return 0;
}
