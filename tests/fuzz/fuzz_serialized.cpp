// Any bytes as a file of serialized meshes; where the first one is odd, as the contents of a mesh, which are packed first: the fuzzer need not
// find out how zlib works.
#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "fuzz/check_mesh.h"
#include "scene/meshes/read_serialized.h"

namespace {

template <class T>
void put(std::string& bytes, T value) {
    for (std::size_t k = 0; k < sizeof(T); ++k) bytes += static_cast<char>((static_cast<std::uint64_t>(value) >> (8 * k)) & 255U);
}

std::string packed(const std::string& mesh) {
    uLongf size = compressBound(mesh.size());
    std::string bytes(size, '\0');
    compress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(mesh.data()), mesh.size());
    std::string file;
    put(file, std::uint16_t{0x041C});
    put(file, std::uint16_t{4});
    file += bytes.substr(0, size);
    put(file, std::uint64_t{0});
    put(file, std::uint32_t{1});
    return file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    const std::string file = data[0] % 2 == 1 ? packed(bytes) : bytes;
    pencil::fuzz::accept_scene_errors([&] { pencil::fuzz::check_mesh(pencil::read_serialized(file, 0, "input.serialized")); });
    return 0;
}
