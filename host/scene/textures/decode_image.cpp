// OpenImageIO opens whatever it can name and believes sizes in headers: so the plugin is chosen here.
#include "scene/textures/decode_image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <exception>
#include <glm/vec3.hpp>
#include <memory>
#include <new>

#include "scene/scene_file.h"
#include "scene/text.h"
#include "util/error.h"

namespace pencil {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t head_size = 64;
/// Formats pack no more pixels into a byte, but for TIFF's codes: runs of 128 in a few bytes, or deflate's 1032 bytes of 8 pixels each. Small files may say what they like.
constexpr std::uint64_t pixels_of_run_byte = 128, pixels_of_byte = 8256, free_pixels = 1 << 20;
constexpr std::uintmax_t max_image_bytes = std::uintmax_t{2} << 30;

unsigned byte_at(std::string_view head, std::size_t i) { return static_cast<unsigned char>(head[i]); }

/// TGA has no signature; its header has few meaningful values.
bool is_targa(std::string_view head, std::uint64_t size) {
    constexpr std::size_t header = 18;
    if (head.size() < header || size < header) return false;
    const unsigned map = byte_at(head, 1), kind = byte_at(head, 2), bits = byte_at(head, 16);
    const unsigned width = byte_at(head, 12) + 256 * byte_at(head, 13), height = byte_at(head, 14) + 256 * byte_at(head, 15);
    const bool known_kind = kind == 1 || kind == 2 || kind == 3 || kind == 9 || kind == 10 || kind == 11;
    const bool known_bits = bits == 8 || bits == 15 || bits == 16 || bits == 24 || bits == 32;
    return map <= 1 && known_kind && known_bits && width > 0 && height > 0;
}

class Decoder {
public:
    Decoder(std::string name, const std::string& where) : name_(std::move(name)), where_(where) {}

    std::unique_ptr<OIIO::ImageInput> plugin(std::string_view head, std::uint64_t size) const {
        const std::string format = image_format(head, size);
        if (format.empty()) fail("is not a picture in a known format (PNG, JPEG, OpenEXR, Radiance HDR, TIFF, BMP, TGA, PNM)");
        std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(format);
        if (!input) fail("cannot be read: OpenImageIO was built without " + format + (" (" + OIIO::geterror() + ")"));
        return input;
    }

    /// Of an input that is open, of so many `bytes`.
    DecodedImage decode(OIIO::ImageInput& input, std::uint64_t bytes) const {
        const OIIO::ImageSpec& spec = input.spec();
        check_size(spec, input.format_name(), bytes);
        DecodedImage image;
        image.width = spec.width;
        image.height = spec.height;
        image.is_encoded = !spec.format.is_floating_point();
        image.is_bytes = spec.format == OIIO::TypeDesc::UINT8;
        const int channels = std::min(spec.nchannels, 4);
        image.has_opacity = channels == 2 || channels == 4;
        image.texels.resize(std::size_t(spec.width) * spec.height, glm::vec4(0, 0, 0, 1));
        if (!input.read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, image.texels.data(), sizeof(glm::vec4)))
            fail("is damaged: " + input.geterror());
        if (channels < 3)
            for (glm::vec4& texel : image.texels) texel = glm::vec4(glm::vec3(texel.x), channels == 2 ? texel.y : 1.0F);
        return image;
    }

    /// Runs `read`, whose every failure becomes a SceneError.
    template <class Read>
    DecodedImage guarded(const Read& read) const {
        try {
            return read();
        } catch (const Error&) {
            throw;
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const std::exception& error) {
            fail(std::string("is damaged: ") + error.what());
        }
    }

    [[noreturn]] void fail(const std::string& message) const { throw SceneError(where_, in_quotes(name_) + " " + escaped(message, 300)); }

private:
    void check_size(const OIIO::ImageSpec& spec, const std::string& format, std::uint64_t bytes) const {
        if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 || spec.depth > 1) fail("has no pixels");
        if (spec.deep) fail("is a deep image, which cannot be read");
        const std::uint64_t pixels = static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height);
        if (pixels > max_texels) {
            fail("is too large: " + std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels; at most " +
                 std::to_string(max_texels) + " are read");
        }
        const bool packs_runs = format == "targa" || format == "bmp" || format == "pnm" || format == "hdr";
        if (format != "tiff" && pixels > free_pixels + (packs_runs ? pixels_of_run_byte : pixels_of_byte) * bytes)
            fail("is damaged: " + std::to_string(bytes) + " bytes do not hold " + std::to_string(spec.width) + " x " +
                 std::to_string(spec.height) + " pixels");
    }

    std::string name_;
    const std::string& where_;
};

/// Colours as stored: OpenImageIO would multiply them by their opacity.
OIIO::ImageSpec as_stored() {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    return config;
}

}  // namespace

std::string image_format(std::string_view head, std::uint64_t size) {
    const auto opens_with = [&](std::string_view magic) { return head.substr(0, magic.size()) == magic; };
    if (opens_with("\x76\x2f\x31\x01"sv)) return "openexr";
    if (opens_with("\x89PNG\r\n\x1a\n"sv)) return "png";
    if (opens_with("\xff\xd8\xff"sv)) return "jpeg";
    if (opens_with("#?RADIANCE"sv) || opens_with("#?RGBE"sv)) return "hdr";
    if (opens_with("II*\0"sv) || opens_with("MM\0*"sv)) return "tiff";
    if (opens_with("BM"sv)) return "bmp";
    const bool is_pnm = head.size() > 2 && head[0] == 'P' && std::string_view("123456Ff").find(head[1]) != std::string_view::npos;
    if (is_pnm && std::string_view(" \t\r\n").find(head[2]) != std::string_view::npos) return "pnm";
    return is_targa(head, size) ? "targa" : "";
}

DecodedImage decode_image_file(const std::filesystem::path& file, const std::string& where) {
    const std::string head = read_head(file, head_size, where);  // refuses what is no regular file
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    const Decoder decoder(file.string(), where);
    if (error || size > max_image_bytes) decoder.fail("has more than " + std::to_string(max_image_bytes) + " bytes");
    return decoder.guarded([&] {
        const std::unique_ptr<OIIO::ImageInput> input = decoder.plugin(head, size);
        OIIO::ImageSpec spec;
        if (!input->open(file.string(), spec, as_stored())) decoder.fail("is damaged: " + input->geterror());
        return decoder.decode(*input, size);
    });
}

DecodedImage decode_image_bytes(std::string_view bytes, const std::string& name, const std::string& where) {
    const Decoder decoder(name, where);
    return decoder.guarded([&] {
        const std::unique_ptr<OIIO::ImageInput> input = decoder.plugin(bytes.substr(0, head_size), bytes.size());
        if (!input->supports("ioproxy")) decoder.fail("is in a format that is only read from files of their own");
        OIIO::Filesystem::IOMemReader reader(const_cast<char*>(bytes.data()), bytes.size());  // it does not write
        OIIO::ImageSpec config = as_stored(), spec;
        void* proxy = &reader;
        config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
        if (!input->open(name, spec, config)) decoder.fail("is damaged: " + input->geterror());
        DecodedImage image = decoder.decode(*input, bytes.size());
        input->close();  // before the reader goes
        return image;
    });
}

}  // namespace pencil
