// Files are encoded in memory and written in one go, so that a full disk is our error to report and never half a file.
#include "image/write_image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "image/false_colour.h"
#include "util/error.h"
#include "util/output_file.h"

namespace pencil {
namespace {

/// Raw size above which an EXR is stored, not compressed. 512x512 with 60 float channels (63 MB) takes 1.2 to 2.2 s as zip, 0.6 to
/// 0.8 s as piz and 0.2 to 0.3 s stored, while the low bits of rendered floats let zip save only 5 % (two cores, OpenEXR 3.1).
constexpr std::size_t stored_above = std::size_t{16} << 20;

constexpr int rows_per_write = 64;  // a multiple of the 16 rows of a zip block; bounds the interleaved copy

/// Of layers that PNGs show in false colours.
const std::map<std::string, const char*>& photometric_units() {
    static const std::map<std::string, const char*> units{{"illuminance", "lx"}, {"luminance", "cd/m2"}};
    return units;
}

struct Attribute {
    OIIO::ImageSpec& spec;
    const std::string& name;
    void operator()(int value) const { spec.attribute(name, value); }
    void operator()(double value) const { spec.attribute(name, OIIO::TypeDesc::DOUBLE, &value); }
    void operator()(const std::string& value) const { spec.attribute(name, value); }
};

OIIO::ImageSpec exr_spec(const LayeredImage& image, const Metadata& metadata) {
    std::vector<std::string> names;
    for (const ImageLayer& layer : image.layers) {
        const std::vector<std::string> added = channel_names(layer);
        names.insert(names.end(), added.begin(), added.end());
    }
    OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(names.size()), OIIO::TypeDesc::FLOAT);
    spec.channelnames = names;
    spec.tile_width = spec.tile_height = image.tile;
    const std::size_t raw_bytes = spec.image_bytes();
    spec.attribute("compression", raw_bytes > stored_above ? "none" : "zip:1");
    spec.attribute("DateTime", "");  // OpenImageIO would put the time of day
    for (const auto& [name, value] : metadata) std::visit(Attribute{spec, name}, value);
    return spec;
}

void interleave(const LayeredImage& image, int first_row, int rows, std::size_t stride, std::vector<float>& out) {
    const std::size_t pixels = std::size_t(rows) * image.width;
    const std::size_t first = std::size_t(first_row) * image.width;
    std::size_t offset = 0;
    for (const ImageLayer& layer : image.layers) {
        const float* from = layer.pixels + first * layer.channels;
        for (std::size_t i = 0; i < pixels; ++i) std::copy_n(from + i * layer.channels, layer.channels, &out[i * stride + offset]);
        offset += layer.channels;
    }
}

[[noreturn]] void encoding_failed(const char* format, const std::string& reason) {
    throw OutputError(std::string("cannot encode the image as ") + format + ": " + reason);
}

std::vector<unsigned char> encode_exr(const LayeredImage& image, const Metadata& metadata) {
    const OIIO::ImageSpec spec = exr_spec(image, metadata);
    OIIO::attribute("exr_threads", 0);  // all cores; the bytes do not depend on it
    std::vector<unsigned char> bytes;
    bytes.reserve(spec.image_bytes() + spec.image_bytes() / 16);
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::unique_ptr<OIIO::ImageOutput> out = OIIO::ImageOutput::create("openexr");
    if (!out) encoding_failed("EXR", OIIO::geterror());
    out->set_ioproxy(&memory);
    if (!out->open("memory.exr", spec)) encoding_failed("EXR", out->geterror());
    const int step = image.tile > 0 ? image.tile : rows_per_write;
    std::vector<float> block(std::size_t(step) * image.width * spec.nchannels);
    for (int y = 0; y < image.height; y += step) {
        const int end = std::min(y + step, image.height);
        interleave(image, y, end - y, static_cast<std::size_t>(spec.nchannels), block);
        const bool written = image.tile > 0 ? out->write_tiles(0, image.width, y, end, 0, 1, OIIO::TypeDesc::FLOAT, block.data())
                                            : out->write_scanlines(y, end, 0, OIIO::TypeDesc::FLOAT, block.data());
        if (!written) encoding_failed("EXR", out->geterror());
    }
    if (!out->close()) encoding_failed("EXR", out->geterror());
    return bytes;
}

unsigned char to_display(float linear) {
    const float shown = std::isfinite(linear) ? linear_to_srgb(std::clamp(linear, 0.0F, 1.0F)) : 0.0F;
    return static_cast<unsigned char>(std::lround(255.0F * shown));
}

std::string describe(const NonFinite& found, const std::filesystem::path& path, bool zeroed) {
    return fmt::format("{}: {} values are NaN or infinite{}, the first in channel {} at pixel ({}, {})", path.filename().string(),
                       found.values, (zeroed ? " and written as 0" : ""), found.channel, found.x, found.y);
}

std::vector<std::string> write_false_colours(const std::filesystem::path& path, const LayeredImage& image, const std::string& name) {
    const auto layer = std::find_if(image.layers.begin(), image.layers.end(), [&](const ImageLayer& l) { return l.name == name; });
    if (layer == image.layers.end()) throw OutputError("cannot write " + path.string() + ": the image has no layer " + name);
    const std::vector<float> values(layer->pixels, layer->pixels + std::size_t(image.width) * image.height);
    const Picture picture = false_colours(values, image.width, image.height, photometric_units().at(name));
    const std::vector<unsigned char> bytes = encode_png({picture.width, picture.height, {{"", 3, picture.rgb.data()}}});
    write_file(path, bytes.data(), bytes.size());
    const NonFinite found = find_non_finite({image.width, image.height, {*layer}});
    return found.values == 0 ? std::vector<std::string>{} : std::vector<std::string>{describe(found, path, false)};
}

std::string lower_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

}  // namespace

std::vector<std::string> channel_names(const ImageLayer& layer) {
    const bool vector = layer.name == "normal" || layer.name == "position";
    const std::string_view letters = photometric_units().count(layer.name) > 0 ? "Y" : layer.channels == 1 ? "Z" : vector ? "XYZ" : "RGBA";
    if (layer.channels < 1 || static_cast<std::size_t>(layer.channels) > letters.size())
        throw OutputError(fmt::format("layer \"{}\" has {} channels", layer.name, layer.channels));
    std::vector<std::string> names;
    names.reserve(static_cast<std::size_t>(layer.channels));
    for (int i = 0; i < layer.channels; ++i) names.push_back((layer.name.empty() ? "" : layer.name + ".") + letters[i]);
    return names;
}

NonFinite find_non_finite(const LayeredImage& image) {
    NonFinite found;
    for (const ImageLayer& layer : image.layers) {
        const std::size_t values = std::size_t(image.width) * image.height * layer.channels;
        for (std::size_t i = 0; i < values; ++i) {
            if (std::isfinite(layer.pixels[i])) continue;
            if (found.values++ == 0) {
                const std::size_t pixel = i / layer.channels;
                found.channel = channel_names(layer)[i % layer.channels];
                found.x = static_cast<int>(pixel % image.width);
                found.y = static_cast<int>(pixel / image.width);
            }
        }
    }
    return found;
}

ImageFormat image_format(const std::filesystem::path& path) {
    const std::string extension = lower_case(path.extension().string());
    if (extension != ".exr" && extension != ".png")
        throw UsageError("cannot write " + path.string() + ": the extension must be .exr or .png");
    return extension == ".png" ? ImageFormat::png : ImageFormat::exr;
}

std::vector<unsigned char> encode_png(const LayeredImage& image) {
    const ImageLayer& beauty = image.layers.front();
    const std::size_t values = std::size_t(image.width) * image.height * beauty.channels;
    std::vector<unsigned char> pixels(values);
    std::transform(beauty.pixels, beauty.pixels + values, pixels.begin(), to_display);

    OIIO::ImageSpec spec(image.width, image.height, beauty.channels, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::unique_ptr<OIIO::ImageOutput> out = OIIO::ImageOutput::create("png");
    if (!out) encoding_failed("PNG", OIIO::geterror());
    out->set_ioproxy(&memory);
    if (!out->open("memory.png", spec) || !out->write_image(OIIO::TypeDesc::UINT8, pixels.data()) || !out->close())
        encoding_failed("PNG", out->geterror());
    return bytes;
}

std::string photometric_word(const std::filesystem::path& path) {
    const std::string word = lower_case(path.stem().extension().string()), name = word.empty() ? word : word.substr(1);
    return photometric_units().count(name) > 0 ? name : "";
}

std::string layer_of_name(const std::filesystem::path& path) {
    return image_format(path) == ImageFormat::png ? photometric_word(path) : "";
}

std::vector<std::string> write_image(const std::filesystem::path& path, const LayeredImage& image, const Metadata& metadata) {
    const bool png = image_format(path) == ImageFormat::png;
    if (const std::string name = layer_of_name(path); !name.empty()) return write_false_colours(path, image, name);
    const std::vector<unsigned char> bytes = png ? encode_png(image) : encode_exr(image, metadata);
    write_file(path, bytes.data(), bytes.size());
    const NonFinite found = png ? find_non_finite({image.width, image.height, {image.layers.front()}}) : find_non_finite(image);
    return found.values == 0 ? std::vector<std::string>{} : std::vector<std::string>{describe(found, path, png)};
}

float linear_to_srgb(float linear) {
    // IEC 61966-2-1
    return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F;
}

float srgb_to_linear(float shown) {
    // IEC 61966-2-1
    return shown <= 0.04045F ? shown / 12.92F : std::pow((shown + 0.055F) / 1.055F, 2.4F);
}

}  // namespace pencil
