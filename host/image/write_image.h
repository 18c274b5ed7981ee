// Images to files: EXR with named float layers, PNG for display. Equal inputs give equal bytes, whatever the file is called: no dates,
// no paths, no times but those that the caller puts into the metadata.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace pencil {

/// One image of several that share a size; rows from the top, `channels` floats per pixel.
struct ImageLayer {
    std::string name;  // "" stands for the beauty
    int channels = 3;
    const float* pixels = nullptr;
};

struct LayeredImage {
    int width = 0, height = 0;
    std::vector<ImageLayer> layers;  // beauty first
    int tile = 0;                    // width of the square tiles that an EXR is stored in, of which single ones can be read; 0: rows
};

using Metadata = std::map<std::string, std::variant<int, double, std::string>>;

/// Values that are no number, and where the first of them stands.
struct NonFinite {
    std::uint64_t values = 0;
    std::string channel;
    int x = 0, y = 0;
};

/// "R", "G", "B" for the beauty; "direct.R" ..., "normal.X" ..., "depth.Z".
std::vector<std::string> channel_names(const ImageLayer& layer);

NonFinite find_non_finite(const LayeredImage& image);

enum class ImageFormat { exr, png };

/// By the extension, in any case. UsageError for others.
ImageFormat image_format(const std::filesystem::path& path);

/// The photometric layer named by the word before the extension, in any case: "illuminance" of "room.illuminance.exr"; empty: none.
std::string photometric_word(const std::filesystem::path& path);
/// The photometric layer that a PNG is of: its photometric_word; empty: the beauty.
std::string layer_of_name(const std::filesystem::path& path);

/// Writes an OpenEXR (.exr: all layers, linear float) or a PNG (.png: the beauty, exposure 1, clamped to [0, 1], sRGB curve, 8 bit;
/// values that are no number become 0; or the layer_of_name, in false colours). Returns warnings. UsageError for another extension, OutputError
/// if writing fails or the image has no such layer.
std::vector<std::string> write_image(const std::filesystem::path& path, const LayeredImage& image, const Metadata& metadata = {});

/// The bytes of such a PNG.
std::vector<unsigned char> encode_png(const LayeredImage& image);

/// The sRGB transfer curve: linear [0, 1] to display value [0, 1]. The inverse of `srgb_to_linear`.
float linear_to_srgb(float linear);
/// Display value [0, 1] to linear [0, 1]. The inverse of `linear_to_srgb`.
float srgb_to_linear(float shown);

}  // namespace pencil
