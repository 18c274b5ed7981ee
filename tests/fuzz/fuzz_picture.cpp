// Any bytes as a picture: an error that names it, or as many texels as its size says.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/check_mesh.h"
#include "scene/textures/decode_image.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    pencil::fuzz::accept_scene_errors([&] {
        const pencil::DecodedImage image = pencil::decode_image_bytes(bytes, "input", "scene.xml:1");
        pencil::fuzz::require(image.width > 0 && image.height > 0);
        pencil::fuzz::require(image.texels.size() == static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    });
    return 0;
}
