#include "field/field_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <sstream>

#include "image/read_image.h"
#include "image/write_image.h"
#include "util/error.h"
#include "util/format.h"

namespace pencil {

namespace {

constexpr const char *centres_key = "pencil:centres", *map_key = "pencil:map", *share_key = "pencil:freeShare",
                     *orders_key = "pencil:orders", *from_key = "pencil:from";
constexpr int map_step = 8, largest_map = 1024;
constexpr std::size_t most_pencils = 1 << 16;
constexpr int most_orders = 1 << 20;
constexpr double largest_coordinate = 1e30;

[[noreturn]] void no_field(const std::filesystem::path& path, const std::string& why) {
    throw SceneError(path.string(), "no field of pencils: " + why + "; `pencil bake` writes one");
}

const std::string& header(const Image& image, const std::string& key, const std::filesystem::path& path) {
    const auto found = image.metadata.find(key);
    if (found == image.metadata.end()) no_field(path, "its header has no " + key);
    return found->second;
}

double number(const Image& image, const std::string& key, double low, double high, const std::filesystem::path& path) {
    std::istringstream text(header(image, key, path));
    double value = 0;
    if (!(text >> value) || !(value >= low && value <= high))
        no_field(path, key + " is not from " + fmt::format("{:g} to {:g}", low, high));
    return value;
}

std::vector<glm::dvec3> read_centres(const Image& image, const std::filesystem::path& path) {
    std::istringstream text(header(image, centres_key, path));
    std::vector<glm::dvec3> centres;
    for (glm::dvec3 c; text >> c.x >> c.y >> c.z;) {
        const glm::dvec3 size = glm::abs(c);
        if (!(std::max({size.x, size.y, size.z}) <= largest_coordinate))
            no_field(path, fmt::format("centre {} is not finite", centres.size()));
        if (centres.size() == most_pencils) no_field(path, fmt::format("it has more than {} pencils", most_pencils));
        centres.push_back(c);
    }
    if (!text.eof() || centres.empty()) no_field(path, "its centres are no list of x y z");
    return centres;
}

/// All but the light.
PencilField read_head(const Image& image, const std::filesystem::path& path) {
    PencilField field;
    field.map = static_cast<int>(number(image, map_key, map_step, largest_map, path));
    if (field.map % map_step != 0) no_field(path, fmt::format("{} is not a multiple of {}", map_key, map_step));
    field.free_share = number(image, share_key, 0, 1, path);
    if (image.metadata.count(orders_key) > 0) field.orders = static_cast<int>(number(image, orders_key, 1, most_orders, path));
    field.centres = read_centres(image, path);
    if (image.width != field.width() || image.height != field.height())
        no_field(path, fmt::format("{} maps of {} texels make an image of {}x{}, it has {}x{}", field.count(), field.map, field.width(),
                                   field.height(), image.width, image.height));
    return field;
}

/// rgb of pixels that have all channels of the image; `name` of pixel number i.
template <typename Name>
std::vector<float> read_light(const Image& image, const std::vector<float>& values, const Name& name, const std::filesystem::path& path) {
    std::size_t channels[3];
    for (std::size_t c = 0; c < 3; ++c) {
        const std::string wanted(1, "RGB"[c]);
        const auto found = std::find(image.channels.begin(), image.channels.end(), wanted);
        if (found == image.channels.end()) no_field(path, "it has no channel " + wanted);
        channels[c] = static_cast<std::size_t>(found - image.channels.begin());
    }
    const std::size_t pixels = values.size() / image.channels.size();
    std::vector<float> light(3 * pixels);
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const float value = values[i * image.channels.size() + channels[c]];
            if (!(value >= 0 && std::isfinite(value))) no_field(path, name(i) + " is no amount of light");
            light[3 * i + c] = value;
        }
    return light;
}

}  // namespace

std::uint64_t field_bytes(int pencils, int map) {
    PencilField field;
    field.map = map;
    field.centres.resize(static_cast<std::size_t>(pencils));
    return std::uint64_t{3} * sizeof(float) * static_cast<std::uint64_t>(field.width()) * static_cast<std::uint64_t>(field.height());
}

void check_field_size(int pencils, int map) {
    const std::uint64_t bytes = field_bytes(pencils, map);
    if (bytes > largest_image)
        throw UsageError(
            fmt::format("a field of {} pencils with maps of {} x {} texels takes {}, and a render accepts {} at most; try fewer "
                        "--pencils or a smaller --map",
                        pencils, map, map, format_size(bytes), format_size(largest_image)));
}

void write_field(const std::filesystem::path& path, const PencilField& field, const std::string& from) {
    std::string centres;
    for (const glm::dvec3& c : field.centres)
        centres += fmt::format("{}{:.17g} {:.17g} {:.17g}", centres.empty() ? "" : " ", c.x, c.y, c.z);
    const LayeredImage image{field.width(), field.height(), {{"", 3, field.light.data()}}, field.map};
    Metadata header{{centres_key, centres}, {map_key, field.map}, {share_key, field.free_share}, {from_key, from}};
    if (field.orders >= 0) header[orders_key] = field.orders;
    write_image(path, image, header);
}

PencilField read_field(const std::filesystem::path& path) {
    const Image image = read_image(path);
    PencilField field = read_head(image, path);
    field.light = read_light(
        image, image.pixels, [&](std::size_t i) { return fmt::format("pixel {}", i); }, path);
    return field;
}

FieldFile::FieldFile(const std::filesystem::path& path) : path_(path), parts_(path), head_(read_head(parts_.head(), path)) {}

std::vector<float> FieldFile::light(int pencil) {
    const int map = head_.map, columns = head_.columns();
    const std::vector<float> pixels = parts_.read(pencil % columns * map, pencil / columns * map, map, map);
    return read_light(
        parts_.head(), pixels, [&](std::size_t i) { return fmt::format("texel {} of pencil {}", i, pencil); }, path_);
}

void open_field(const std::filesystem::path& path, RenderOptions& options) {
    if (options.field_pencils == 0) {
        options.field = std::make_shared<PencilField>(read_field(path));
        return;
    }
    auto file = std::make_shared<FieldFile>(path);
    options.field = std::make_shared<PencilField>(file->head());
    options.field_source = std::move(file);
}

}  // namespace pencil
