#include "scene/meshes/inflate.h"

#include <zlib.h>

#include <algorithm>
#include <limits>

#include "util/error.h"

namespace pencil {

struct Inflate::State {
    z_stream stream{};
    std::string_view left;  // not yet given to zlib
    const std::string& name;
};

Inflate::Inflate(std::string_view packed, const std::string& name) : state_(new State{{}, packed, name}) {
    if (inflateInit(&state_->stream) != Z_OK) throw SceneError(name, "cannot be unpacked");
}

Inflate::~Inflate() { inflateEnd(&state_->stream); }

void Inflate::read(void* to, std::size_t bytes) {
    constexpr std::size_t most = std::numeric_limits<uInt>::max() / 2;  // zlib counts in 32 bits
    auto* next = static_cast<Bytef*>(to);
    z_stream& stream = state_->stream;
    while (bytes > 0) {
        if (stream.avail_in == 0) {
            const std::size_t part = std::min(state_->left.size(), most);
            stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(state_->left.data()));  // zlib does not write there
            stream.avail_in = static_cast<uInt>(part);
            state_->left.remove_prefix(part);
        }
        const std::size_t part = std::min(bytes, most);
        stream.next_out = next;
        stream.avail_out = static_cast<uInt>(part);
        const int status = inflate(&stream, Z_NO_FLUSH);
        const std::size_t made = part - stream.avail_out;
        next += made;
        bytes -= made;
        if (status == Z_STREAM_END && bytes > 0) throw SceneError(state_->name, "the packed data end too early");
        if (status != Z_OK && status != Z_STREAM_END) throw SceneError(state_->name, "the packed data are damaged or end too early");
    }
}

std::size_t Inflate::most_left() const {
    constexpr std::size_t best_ratio = 1032;  // of DEFLATE
    constexpr std::size_t window = 65536;     // that zlib may hold unpacked
    return (state_->left.size() + state_->stream.avail_in) * best_ratio + window;
}

}  // namespace pencil
