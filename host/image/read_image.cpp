// OpenImageIO opens whatever it can name and believes sizes in headers, so the format is chosen here by the first bytes, the size is
// judged before any allocation, and every kind of failure becomes one error.
#include "image/read_image.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

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
    if (!fs::is_regular_file(path, error)) {
        throw SceneError(path.string(), fs::exists(path, error) ? "not a regular file" : "no such file");
    }
    std::ifstream file(path, std::ios::binary);
    std::array<char, 16> bytes{};
    file.read(bytes.data(), bytes.size());
    if (file.bad() || !file.is_open()) {
        throw SceneError(path.string(), "cannot be read");
    }
    const std::string_view start(bytes.data(), static_cast<std::size_t>(file.gcount()));
    const auto opens_with = [&](std::string_view magic) { return start.substr(0, magic.size()) == magic; };
    if (opens_with("\x76\x2f\x31\x01"sv)) {
        return "openexr";
    }
    if (opens_with("\x89PNG\r\n\x1a\n"sv)) {
        return "png";
    }
    if (opens_with("#?RADIANCE"sv) || opens_with("#?RGBE"sv)) {
        return "hdr";
    }
    throw SceneError(path.string(), "not an OpenEXR, PNG or Radiance HDR image");
}

void check_size(const fs::path& path, const OIIO::ImageSpec& spec, std::uint64_t most_bytes) {
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 || spec.depth > 1) {
        throw SceneError(path.string(), "has no pixels");
    }
    // Each factor is below 2^31; dividing keeps the product from overflowing.
    const std::uint64_t most_pixels = most_bytes / sizeof(float) / static_cast<std::uint64_t>(spec.nchannels);
    const std::uint64_t pixels = static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height);
    if (pixels > most_pixels) {
        throw SceneError(path.string(), fmt::format("is too large: {}x{} pixels of {} channels; at most {} MiB are accepted", spec.width,
                                                    spec.height, spec.nchannels, most_bytes >> 20));
    }
    if (spec.deep) {
        throw SceneError(path.string(), "deep images are not supported");
    }
}

Image read(const fs::path& path, std::uint64_t most_bytes) {
    const std::string format = format_of(path);
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(format);
    OIIO::ImageSpec spec;
    if (!input || !input->open(path.string(), spec)) {
        throw SceneError(path.string(), "is damaged: " + (input ? input->geterror() : OIIO::geterror()));
    }
    check_size(path, spec, most_bytes);
    Image image;
    image.width = spec.width;
    image.height = spec.height;
    image.channels = spec.channelnames;
    image.display = format == "png";
    if (format == "openexr") {
        for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
            image.metadata[attribute.name().string()] = attribute.get_string();
        }
    }
    image.pixels.resize(std::size_t(spec.width) * spec.height * spec.nchannels);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.pixels.data())) {
        throw SceneError(path.string(), "is damaged: " + input->geterror());
    }
    return image;
}

}  // namespace

Image read_image(const fs::path& path, std::uint64_t most_bytes) {
    try {
        return read(path, most_bytes);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw SceneError(path.string(), std::string("is damaged: ") + error.what());
    }
}

}  // namespace pencil
