// The image that errors are measured against, and how far it can be trusted itself.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "converge/options.h"
#include "options/render_result.h"
#include "scene/scene.h"

namespace pencil {

struct Truth {
    std::string name;    // of the file
    std::string origin;  // one sentence: what made it
    int width = 0, height = 0;
    std::vector<float> rgb;               // linear, 3 floats per pixel
    double exposure = 1;                  // of displayed colours
    std::optional<double> noise_rel_mse;  // estimated relMSE of the truth itself
    std::string fingerprint;              // of the pixels
    std::vector<std::string> warnings;    // another scene, unfinished, not finite
};

/// Reads an image whose size must be that of `options`. SceneError if it cannot be used.
Truth read_truth(const std::filesystem::path& file, const Scene& scene, const ConvergeOptions& options);

/// Traces the truth for `truth_seconds` in two independent halves, whose difference tells its noise, and keeps it in the folder; takes it
/// from there if it is that of this scene, size and number of reflections. Nothing if `progress` stops it.
std::optional<Truth> own_truth(const Scene& scene, const ConvergeOptions& options, const Progress& progress);
double truth_seconds(const ConvergeOptions& options);

/// relMSE of the mean of two independent images of equal quality, estimated from their difference: a quarter of what separates them.
double noise_of_halves(const std::vector<float>& a, const std::vector<float>& b);

}  // namespace pencil
