// OpenImageIO opens whatever it can name and believes sizes in headers, so the format is chosen here by the first bytes, the size is
// judged before any allocation, and every kind of failure becomes one error.
#include "image/read_image.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <exception>
#include <fstream>
#include <string_view>

#include "util/error.h"

namespace pencil {
namespace {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

std::string format_of(const fs::path& path) {
    std::error_code error;
    if (!fs::is_regular_file(path, error)) throw SceneError(path.string(), fs::exists(path, error) ? "not a regular file" : "no such file");
    std::ifstream file(path, std::ios::binary);
    std::array<char, 16> bytes{};
    file.read(bytes.data(), bytes.size());
    if (file.bad() || !file.is_open()) throw SceneError(path.string(), "cannot be read");
    const std::string_view start(bytes.data(), static_cast<std::size_t>(file.gcount()));
    const auto opens_with = [&](std::string_view magic) { return start.substr(0, magic.size()) == magic; };
    if (opens_with("\x76\x2f\x31\x01"sv)) return "openexr";
    if (opens_with("\x89PNG\r\n\x1a\n"sv)) return "png";
    if (opens_with("#?RADIANCE"sv) || opens_with("#?RGBE"sv)) return "hdr";
    throw SceneError(path.string(), "not an OpenEXR, PNG or Radiance HDR image");
}

void check_size(const fs::path& path, const OIIO::ImageSpec& spec, std::uint64_t most_bytes) {
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 || spec.depth > 1) throw SceneError(path.string(), "has no pixels");
    // Each factor is below 2^31; dividing keeps the product from overflowing.
    const std::uint64_t most_pixels = most_bytes / sizeof(float) / static_cast<std::uint64_t>(spec.nchannels);
    const std::uint64_t pixels = static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height);
    if (pixels > most_pixels) {
        throw SceneError(path.string(), fmt::format("is too large: {}x{} pixels of {} channels; at most {} MiB are accepted", spec.width,
                                                    spec.height, spec.nchannels, most_bytes >> 20));
    }
    if (spec.deep) throw SceneError(path.string(), "deep images are not supported");
}

struct Opened {
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::ImageSpec spec;
    Image head;  // without pixels
};

Opened open(const fs::path& path, std::uint64_t most_bytes) {
    const std::string format = format_of(path);
    Opened opened{OIIO::ImageInput::create(format), {}, {}};
    OIIO::ImageSpec& spec = opened.spec;
    if (!opened.input || !opened.input->open(path.string(), spec))
        throw SceneError(path.string(), "is damaged: " + (opened.input ? opened.input->geterror() : OIIO::geterror()));
    check_size(path, spec, most_bytes);
    Image& image = opened.head;
    image.width = spec.width;
    image.height = spec.height;
    image.channels = spec.channelnames;
    image.display = format == "png";
    if (format == "openexr")
        for (const OIIO::ParamValue& attribute : spec.extra_attribs) image.metadata[attribute.name().string()] = attribute.get_string();
    return opened;
}

Image read(const fs::path& path, std::uint64_t most_bytes) {
    Opened opened = open(path, most_bytes);
    const OIIO::ImageSpec& spec = opened.spec;
    Image image = std::move(opened.head);
    image.pixels.resize(std::size_t(spec.width) * spec.height * spec.nchannels);
    if (!opened.input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.pixels.data()))
        throw SceneError(path.string(), "is damaged: " + opened.input->geterror());
    return image;
}

/// Calls `work`, of whose failures all become one error.
template <typename Work>
auto guarded(const fs::path& path, Work work) -> decltype(work()) {
    try {
        return work();
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw SceneError(path.string(), std::string("is damaged: ") + error.what());
    }
}

/// From `first` to `end`, widened to whole steps of a range of `size`.
struct Span {
    Span(int first, int past, int step, int size)
        : begin(step > 0 ? first / step * step : 0), end(step > 0 ? std::min((past + step - 1) / step * step, size) : size) {}
    int begin, end;
};

}  // namespace

Image read_image(const fs::path& path, std::uint64_t most_bytes) {
    return guarded(
        path, [&] { return read(path, most_bytes); });
}

struct ImageParts::File {
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::ImageSpec spec;
};

ImageParts::ImageParts(const fs::path& path, std::uint64_t most_bytes) : path_(path) {
    guarded(
        path,
        [&] {
            Opened opened = open(path, most_bytes);
            head_ = std::move(opened.head);
            file_ = std::make_unique<File>(File{std::move(opened.input), opened.spec});
        });
}

ImageParts::~ImageParts() = default;

std::vector<float> ImageParts::read(int x, int y, int width, int height) {
    const OIIO::ImageSpec& spec = file_->spec;
    const bool tiled = spec.tile_width > 0;
    const Span columns(x, x + width, spec.tile_width, spec.width), rows(y, y + height, tiled ? spec.tile_height : 1, spec.height);
    const auto across = static_cast<std::size_t>(columns.end - columns.begin), channels = static_cast<std::size_t>(spec.nchannels);
    std::vector<float> read(across * static_cast<std::size_t>(rows.end - rows.begin) * channels);
    guarded(path_, [&] {
        const bool done = tiled ? file_->input->read_tiles(0, 0, spec.x + columns.begin, spec.x + columns.end, spec.y + rows.begin,
                                                           spec.y + rows.end, 0, 1, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, read.data())
                                : file_->input->read_scanlines(0, 0, spec.y + rows.begin, spec.y + rows.end, 0, 0, spec.nchannels,
                                                               OIIO::TypeDesc::FLOAT, read.data());
        if (!done) throw SceneError(path_.string(), "is damaged: " + file_->input->geterror());
    });
    std::vector<float> out;
    const std::size_t left = static_cast<std::size_t>(x - columns.begin) * channels, row = static_cast<std::size_t>(width) * channels;
    out.reserve(row * static_cast<std::size_t>(height));
    for (int line = y; line < y + height; ++line) {
        const auto from =
            read.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(line - rows.begin) * across * channels + left);
        out.insert(out.end(), from, from + static_cast<std::ptrdiff_t>(row));
    }
    return out;
}

}  // namespace pencil
