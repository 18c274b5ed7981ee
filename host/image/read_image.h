// Images from files, as linear or display values just as they are stored. Files are untrusted: formats are told by content, sizes are
// checked before memory is taken.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace pencil {

struct Image {
    int width = 0, height = 0;
    std::vector<std::string> channels;            // for example "R", "G", "B", "direct.R"
    std::vector<float> pixels;                    // rows from the top, channels interleaved; 8-bit values are divided by 255
    bool display = false;                         // PNG: display values (sRGB curve), not linear ones
    std::map<std::string, std::string> metadata;  // of an OpenEXR header, numbers as text
};

constexpr std::uint64_t largest_image = std::uint64_t{4} << 30;  // [bytes as float]

/// Reads an OpenEXR (first part), PNG or Radiance HDR file. SceneError naming the file if it is none of these, damaged, deep, or would
/// take more than `most_bytes`.
Image read_image(const std::filesystem::path& path, std::uint64_t most_bytes = largest_image);

/// The same file, of which parts are read.
class ImageParts {
public:
    explicit ImageParts(const std::filesystem::path& path, std::uint64_t most_bytes = largest_image);
    ~ImageParts();
    ImageParts(const ImageParts&) = delete;
    ImageParts& operator=(const ImageParts&) = delete;

    /// All but the pixels.
    const Image& head() const { return head_; }
    /// Pixels (x, y) to (x + width, y + height) as Image::pixels. Tiles of the file that hold some of them are read, or whole rows where it has none.
    std::vector<float> read(int x, int y, int width, int height);

private:
    struct File;
    std::filesystem::path path_;
    std::unique_ptr<File> file_;
    Image head_;
};

}  // namespace pencil
