#include "converge/pictures.h"

#include <fmt/format.h>

#include "image/write_image.h"

namespace pencil {
namespace {

constexpr int widest = 400;  // [pixels]

/// RFC 4648.
std::string base64(const std::string& bytes) {
    const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t j = i; j < i + 3; ++j) {
            group = group << 8 | (j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0U);
        }
        for (std::size_t j = 0; j < 4; ++j) {
            const bool padding = i + j > bytes.size();
            text += padding ? '=' : digits[group >> (18 - 6 * j) & 63U];
        }
    }
    return text;
}

/// Means over squares of `factor` pixels; incomplete squares at the right and lower edge are dropped.
std::vector<float> shrink(const std::vector<float>& rgb, int width, int height, int factor) {
    const int small_width = width / factor, small_height = height / factor;
    std::vector<float> small(std::size_t(small_width) * small_height * 3);
    for (int y = 0; y < small_height * factor; ++y) {
        for (int x = 0; x < small_width * factor; ++x) {
            for (int c = 0; c < 3; ++c) {
                small[3 * (std::size_t(y / factor) * small_width + x / factor) + c] +=
                    rgb[3 * (std::size_t(y) * width + x) + c] / static_cast<float>(factor * factor);
            }
        }
    }
    return small;
}

}  // namespace

std::string data_uri(const std::string& mime, const std::string& bytes) { return fmt::format("data:{};base64,{}", mime, base64(bytes)); }

std::string picture_uri(const std::vector<float>& rgb, int width, int height, double exposure) {
    const int factor = (width + widest - 1) / widest;
    std::vector<float> shown = factor > 1 ? shrink(rgb, width, height, factor) : rgb;
    for (float& value : shown) {
        value *= static_cast<float>(exposure);
    }
    const std::vector<unsigned char> png = encode_png({width / factor, height / factor, {{"", 3, shown.data()}}});
    return data_uri("image/png", std::string(png.begin(), png.end()));
}

}  // namespace pencil
