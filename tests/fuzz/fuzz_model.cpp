// Any bytes as an OBJ file opened as a scene; what stands after a line "#mtl" is its library of materials.
#include <cstddef>
#include <cstdint>
#include <string>

#include "fuzz/scene_folder.h"
#include "scene/models/read_model.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const pencil::fuzz::SceneFolder folder;
    const std::string text(reinterpret_cast<const char*>(data), size);
    const std::size_t split = std::min(text.find("#mtl"), text.size());
    pencil::fuzz::write_file(folder.path / "m.obj", text.substr(0, split));
    pencil::fuzz::write_file(folder.path / "m.mtl", text.substr(split));
    pencil::fuzz::accept_scene_errors([&] { pencil::fuzz::check_scene(pencil::read_obj_scene(folder.path / "m.obj", {})); });
    return 0;
}
