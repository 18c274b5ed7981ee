// `pencil compare`: the error of an image against a reference, as a table or as JSON, and where it lies.
// The keys of the JSON are a contract: `schema` counts incompatible changes. Undefined numbers are null, with the reason in `undefined`;
// the PSNR of equal images, which is infinite, is null, too.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "app/commands.h"
#include "app/message.h"
#include "compare/compare_images.h"
#include "compare/difference_image.h"
#include "compare/image_layers.h"
#include "options/option_values.h"
#include "util/format.h"
#include "util/output_file.h"

namespace pencil {
namespace {

using Json = nlohmann::ordered_json;

constexpr int comparison_schema = 1;

std::string non_finite_text(const std::string& layer, const std::string& file, const NonFinite& found) {
    return fmt::format("layer {} of {}: {} values are NaN or infinite, the first in channel {} at pixel ({}, {})", layer, file,
                       found.values, found.channel, found.x, found.y);
}

std::vector<std::string> all_warnings(const Comparison& comparison, const CompareCommand& command) {
    std::vector<std::string> warnings = comparison.warnings;
    for (const LayerComparison& layer : comparison.layers) {
        for (const auto& [file, found] : {std::pair(&command.image, &layer.image), std::pair(&command.reference, &layer.reference)})
            if (found->values > 0) warnings.push_back(non_finite_text(layer.name, file->string(), *found));
        if (layer.metrics.excluded > 0)
            warnings.push_back(fmt::format("layer {}: {} pixels are left out of all averages", layer.name, layer.metrics.excluded));
    }
    return warnings;
}

/// Cells of a table's row after the layer's name.
std::vector<std::string> cells(const Metrics& m) {
    const auto defined = [](double value, const std::string& text) { return std::isnan(value) ? "-" : text; };
    return {defined(m.rmse, format_short(m.rmse)), defined(m.rel_mse, format_short(m.rel_mse)),
            defined(m.mean_ratio, format_fixed(m.mean_ratio, 4)), defined(m.psnr, format_fixed(m.psnr, 2)),
            m.lab_rms ? defined(*m.lab_rms, format_short(*m.lab_rms)) : "-"};
}

void print_row(const std::string& name, const std::vector<std::string>& cells) {
    std::string line = fmt::format("{:<11} ", name);
    for (const std::string& cell : cells) line += fmt::format("{:>12}", cell);
    std::cout << line << "\n";
}

void print_table(const Comparison& comparison, const CompareCommand& command) {
    std::cout << fmt::format("image      {}\nreference  {}\nsize       {}, exposure of displayed colours {}\n\n",
                             printable(command.image.string()), printable(command.reference.string()),
                             format_extent(comparison.width, comparison.height), format_short(comparison.exposure));
    print_row("layer", {"RMSE", "relMSE", "mean ratio", "PSNR dB", "L*a*b* RMS"});
    for (const LayerComparison& layer : comparison.layers) print_row(printable(layer.name), cells(layer.metrics));
    for (const LayerComparison& layer : comparison.layers)
        if (const std::string reason = undefined_reason(layer.metrics); !reason.empty())
            std::cout << fmt::format("-: not defined in {}: {}\n", printable(layer.name), reason);
    for (const auto& [file, names] :
         {std::pair(&command.image, &comparison.only_in_image), std::pair(&command.reference, &comparison.only_in_reference)})
        if (!names->empty()) std::cout << fmt::format("only in {}: {}\n", printable(file->string()), printable(join(*names)));
}

Json non_finite_json(const NonFinite& found) {
    Json json{{"values", found.values}};
    if (found.values > 0) json["first"] = {{"channel", found.channel}, {"x", found.x}, {"y", found.y}};
    return json;
}

Json layer_json(const LayerComparison& layer) {
    const Metrics& m = layer.metrics;
    const std::string reason = undefined_reason(m);
    return {{"name", layer.name},
            {"channels", layer.channels},
            {"rmse", m.rmse},
            {"rel_mse", m.rel_mse},
            {"mean_ratio", m.mean_ratio},
            {"psnr_db", m.psnr},
            {"lab_rms", m.lab_rms ? Json(*m.lab_rms) : Json()},
            {"image_mean", m.image_mean},
            {"reference_mean", m.reference_mean},
            {"undefined", reason.empty() ? Json() : Json(reason)},
            {"pixels", m.pixels},
            {"excluded_pixels", m.excluded},
            {"image_non_finite", non_finite_json(layer.image)},
            {"reference_non_finite", non_finite_json(layer.reference)}};
}

Json comparison_json(const Comparison& comparison, const CompareCommand& command, const std::vector<std::string>& warnings) {
    Json json{{"schema", comparison_schema},
              {"version", PENCIL_VERSION},
              {"image", command.image.string()},
              {"reference", command.reference.string()},
              {"size", {comparison.width, comparison.height}},
              {"exposure", comparison.exposure},
              {"layers", Json::array()},
              {"only_in_image", comparison.only_in_image},
              {"only_in_reference", comparison.only_in_reference},
              {"warnings", warnings}};
    for (const LayerComparison& layer : comparison.layers) json["layers"].push_back(layer_json(layer));
    return json;
}

/// Writes the difference of the beauties and returns the scale of its colours.
double write_difference(const Image& image, const Image& reference, const CompareCommand& command) {
    const std::vector<std::string> rgb{"R", "G", "B"};
    const NamedLayer x = split_layers(image).front(), r = split_layers(reference).front();
    if (x.name != "beauty" || r.name != "beauty" || x.channels != rgb || r.channels != rgb)
        throw SceneError(command.image.string(), "--diff needs the channels R, G and B in both images");
    const std::vector<float> differences = relative_difference(x.pixels.data(), r.pixels.data(), x.pixels.size() / 3);
    const double scale = difference_scale(differences);
    const std::vector<float> colours = false_colour(differences, scale);
    write_image(command.difference, {image.width, image.height, {{"", 3, colours.data()}}}, {{"pencil:differenceScale", scale}});
    return scale;
}

void check_difference_file(const CompareCommand& command) {
    image_format(command.difference);
    for (const std::filesystem::path* input : {&command.image, &command.reference}) {
        std::error_code error;
        if (std::filesystem::equivalent(command.difference, *input, error))
            throw OutputError("cannot write " + command.difference.string() + ": it is one of the images");
    }
    check_writable(command.difference);
}

}  // namespace

ExitCode run_compare(const CompareCommand& command) {
    if (!command.difference.empty()) check_difference_file(command);
    const Image image = read_image(command.image), reference = read_image(command.reference);
    const Comparison comparison = compare_images(image, reference, command.image.string(), command.reference.string());
    const std::vector<std::string> warnings = all_warnings(comparison, command);
    std::for_each(warnings.begin(), warnings.end(), print_warning);
    const double scale = command.difference.empty() ? 0 : write_difference(image, reference, command);
    if (command.json) {
        Json json = comparison_json(comparison, command, warnings);
        if (scale > 0) json["difference"] = {{"file", command.difference.string()}, {"scale", scale}};
        std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
        return ExitCode::ok;
    }
    print_table(comparison, command);
    if (scale > 0) {
        std::cout << fmt::format(
            "wrote      {}: red where the image is too bright, blue where too dark, full colour at {} % of the "
            "reference\n",
            printable(command.difference.string()), format_short(100 * scale));
    }
    return ExitCode::ok;
}

}  // namespace pencil
