#include "converge/truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/compare_images.h"
#include "compare/image_layers.h"
#include "compare/lab.h"
#include "converge/runs.h"
#include "image/write_image.h"
#include "options/layer.h"
#include "scene/scene_fingerprint.h"
#include "util/error.h"
#include "util/fingerprint.h"
#include "util/format.h"

namespace pencil {
namespace {

constexpr double truth_share = 15;  // time of the truth relative to the longest run: its variance is that much smaller
constexpr std::uint64_t first_half_seed = 0x7275746800000000;  // far from the seeds of runs

const char* const noise_key = "pencil:noiseRelMse";
const char* const origin_key = "pencil:origin";

void set_pixels(Truth& truth, std::vector<float> rgb) {
    truth.rgb = std::move(rgb);
    truth.exposure = exposure_of(truth.rgb.data(), truth.rgb.size() / 3);
    truth.fingerprint = fingerprint(truth.rgb.data(), truth.rgb.size() * sizeof(float));
}

/// Relative noise by the layer of variances that `pencil reference` can write, for files that do not say it themselves.
std::optional<double> noise_of(const Image& image, const std::vector<NamedLayer>& layers) {
    const auto said = image.metadata.find(noise_key);
    if (said != image.metadata.end()) return std::stod(said->second);
    const std::vector<std::string> rgb{"R", "G", "B"};
    const auto variance = std::find_if(layers.begin(), layers.end(), [](const NamedLayer& layer) { return layer.name == variance_layer; });
    if (variance == layers.end() || variance->channels != rgb) return {};
    const std::vector<float>& beauty = layers.front().pixels;
    std::vector<float> displaced(beauty.size());
    std::transform(beauty.begin(), beauty.end(), variance->pixels.begin(), displaced.begin(),
                   [](float value, float square) { return value + std::sqrt(std::max(square, 0.0F)); });
    return measure({displaced.data(), beauty.data(), beauty.size() / 3, 3}).rel_mse;
}

std::optional<Truth> cached_truth(const std::filesystem::path& file, const Scene& scene, const ConvergeOptions& options) {
    if (!std::filesystem::exists(file)) return {};
    const Image image = read_image(file);
    const auto is = [&](const char* key, const std::string& value) {
        const auto found = image.metadata.find(key);
        return found != image.metadata.end() && found->second == value;
    };
    if (image.width != options.width || image.height != options.height || !is("pencil:bounces", bounces_text(options)) ||
        !is("pencil:sceneFingerprint", scene_fingerprint(scene)))
        return {};
    return read_truth(file, scene, options);
}

}  // namespace

double truth_seconds(const ConvergeOptions& options) { return truth_share * options.longest; }

double noise_of_halves(const std::vector<float>& a, const std::vector<float>& b) {
    std::vector<float> mean(a.size());
    std::transform(a.begin(), a.end(), b.begin(), mean.begin(), [](float x, float y) { return (x + y) / 2; });
    // a is as far from the mean as the mean is from the truth, on average: half of the difference.
    return measure({a.data(), mean.data(), mean.size() / 3, 3}).rel_mse;
}

Truth read_truth(const std::filesystem::path& file, const Scene& scene, const ConvergeOptions& options) {
    const Image image = read_image(file);
    const std::vector<NamedLayer> layers = split_layers(image);
    if (image.width != options.width || image.height != options.height) {
        throw SceneError(file.string(),
                         fmt::format("the reference has {} pixels, {} are to be measured; use its --resolution",
                                     format_extent(image.width, image.height), format_extent(options.width, options.height)));
    }
    if (layers.front().name != "beauty" || layers.front().channels != std::vector<std::string>{"R", "G", "B"})
        throw SceneError(file.string(), "the reference has no channels R, G and B");
    Truth truth;
    truth.name = file.filename().string();
    truth.width = image.width;
    truth.height = image.height;
    const auto origin = image.metadata.find(origin_key), software = image.metadata.find("Software");
    truth.origin = origin != image.metadata.end()     ? origin->second
                   : software != image.metadata.end() ? fmt::format("by {}", software->second)
                                                      : "of unknown origin";
    truth.noise_rel_mse = noise_of(image, layers);
    set_pixels(truth, layers.front().pixels);
    const auto theirs = image.metadata.find("pencil:sceneFingerprint");
    if (theirs != image.metadata.end() && theirs->second != scene_fingerprint(scene))
        truth.warnings.push_back(fmt::format("the reference {} was made from another scene", file.string()));
    if (image.metadata.count("pencil:interrupted") > 0)
        truth.warnings.push_back(fmt::format("the reference {} is the unfinished image of an interrupted render", file.string()));
    const auto bad = std::count_if(truth.rgb.begin(), truth.rgb.end(), [](float value) { return !std::isfinite(value); });
    if (bad > 0) {
        truth.warnings.push_back(
            fmt::format("the reference {} has {} values that are NaN or infinite; their pixels are left out", file.string(), bad));
    }
    return truth;
}

std::optional<Truth> own_truth(const Scene& scene, const ConvergeOptions& options, const Progress& progress) {
    const std::filesystem::path file = options.folder / "reference.exr";
    if (std::optional<Truth> cached = cached_truth(file, scene, options)) return cached;
    std::vector<TracedImage> halves;
    for (const std::uint64_t half : {0, 1}) {
        const Progress part = [&](const std::string&, double fraction) {
            return !progress || progress("reference", (static_cast<double>(half) + fraction) / 2);
        };
        halves.push_back(trace_image(scene, options, truth_seconds(options) / 2, first_half_seed + half, part));
        if (halves.back().interrupted) return {};
    }
    std::vector<float> rgb(halves[0].rgb.size());
    std::transform(halves[0].rgb.begin(), halves[0].rgb.end(), halves[1].rgb.begin(), rgb.begin(),
                   [](float a, float b) { return (a + b) / 2; });
    const std::string origin =
        fmt::format("made in the same run by the path tracer: two halves of {} and {} paths per pixel", halves[0].spp, halves[1].spp);
    write_image(file, {options.width, options.height, {{"", 3, rgb.data()}}},
                {{"Software", fmt::format("pencil {}", options.version)},
                 {"pencil:scene", options.scene.filename().string()},
                 {"pencil:sceneFingerprint", scene_fingerprint(scene)},
                 {"pencil:bounces", bounces_text(options)},
                 {origin_key, origin},
                 {noise_key, noise_of_halves(halves[0].rgb, halves[1].rgb)}});
    return read_truth(file, scene, options);
}

}  // namespace pencil
