#include "image/false_colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "image/small_font.h"
#include "image/write_image.h"

namespace pencil {

namespace {

using Colour = std::array<float, 3>;  // sRGB display values

constexpr std::array<Colour, 6> stops{{{0.05F, 0.03F, 0.25F},
                                       {0.15F, 0.20F, 0.60F},
                                       {0.05F, 0.48F, 0.62F},
                                       {0.25F, 0.68F, 0.38F},
                                       {0.84F, 0.80F, 0.20F},
                                       {1.00F, 0.98F, 0.78F}}};
constexpr Colour undefined_colour{1.0F, 0.0F, 0.0F}, ink{0.0F, 0.0F, 0.0F};

constexpr double covered_share = 0.99;  // of the values stay below the end of the scale
// The legend [pixels].
constexpr int margin = 8, bar_width = 16, tick = 4, least_height = 96, row_of_labels = 2 * glyph_height;
constexpr int divisions = 10;

void put(Picture& picture, int x, int y, const Colour& colour) {
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return;
    const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
    std::transform(colour.begin(), colour.end(), picture.rgb.begin() + static_cast<std::ptrdiff_t>(at), srgb_to_linear);
}

void write_text(Picture& picture, int left, int top, const std::string& text) {
    draw_text(
        text, [&](int x, int y) { put(picture, left + x, top + y, ink); });
}

std::string label(double value) { return fmt::format("{:g}", value); }

/// Every division has a label where there is room, else every second or fifth.
int label_step(int bar_height) {
    for (const int step : {1, 2, 5})
        if (bar_height * step / divisions >= row_of_labels) return step;
    return divisions;
}

/// From the bottom, 0, to the top.
void draw_legend(Picture& picture, int left, double end, const std::string& unit) {
    const int top = margin + 2 * glyph_height, bottom = picture.height - 1 - margin, high = bottom - top;
    write_text(picture, left, margin - 2, unit);
    for (int y = top; y <= bottom; ++y)
        for (int x = 0; x < bar_width; ++x) put(picture, left + x, y, scale_colour(static_cast<double>(bottom - y) / high));
    for (int k = 0; k <= divisions; k += label_step(high)) {
        const int y = bottom - static_cast<int>(std::lround(static_cast<double>(k) / divisions * high));
        for (int x = 0; x < tick; ++x) put(picture, left + bar_width + x, y, ink);
        write_text(picture, left + bar_width + 2 * tick, y - glyph_height / 2, label(end * k / divisions));
    }
}

}  // namespace

std::array<float, 3> scale_colour(double position) {
    const double along = std::clamp(position, 0.0, 1.0) * (stops.size() - 1);
    const std::size_t stop = std::min(static_cast<std::size_t>(along), stops.size() - 2);
    const auto share = static_cast<float>(along - static_cast<double>(stop));
    Colour colour{};
    for (std::size_t c = 0; c < colour.size(); ++c) colour[c] = stops[stop][c] + share * (stops[stop + 1][c] - stops[stop][c]);
    return colour;
}

double scale_end(std::vector<float> values) {
    values.erase(std::remove_if(values.begin(), values.end(), [](float v) { return !std::isfinite(v); }), values.end());
    if (values.empty()) return 1;
    const auto last = std::min(values.size() - 1, static_cast<std::size_t>(covered_share * static_cast<double>(values.size())));
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(last), values.end());
    const auto covered = static_cast<double>(values[last]);
    if (!(covered > 0)) return 1;
    const double power = std::pow(10.0, std::floor(std::log10(covered)));
    for (const double step : {1.0, 2.0, 5.0})
        if (covered <= step * power) return step * power;
    return 10 * power;
}

Picture false_colours(const std::vector<float>& values, int width, int height, const std::string& unit) {
    const double end = scale_end(values);
    int labels = text_width(unit);
    for (int k = 0; k <= divisions; ++k) labels = std::max(labels, bar_width + 2 * tick + text_width(label(end * k / divisions)));
    Picture picture{width + 2 * margin + labels, std::max(height, least_height), {}};
    picture.rgb.assign(3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height), 1.0F);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float value = values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
            put(picture, x, y, std::isfinite(value) ? scale_colour(static_cast<double>(value) / end) : undefined_colour);
        }
    draw_legend(picture, width + margin, end, unit);
    return picture;
}

}  // namespace pencil
