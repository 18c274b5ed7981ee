// Finished runs, one row each in a CSV file that only ever grows: what an interruption must not lose.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace pencil {

struct RunPoint {
    std::string method;
    int budget = 0;  // step of the method's ladder
    std::uint64_t seed = 0;
    double seconds = 0;        // wall clock of the solve, without kernel builds
    double build_seconds = 0;  // of kernels
    double rmse = 0, rel_mse = 0, mean_ratio = 0, psnr = 0, lab_rms = 0;
    std::uint64_t excluded_pixels = 0;                   // not finite
    double load = 0;                                     // processes that wanted to run in the machine, ours included; 0: not known
    std::string options;                                 // that make this run, as on the command line
    std::vector<std::pair<std::string, double>> stages;  // name and wall seconds, in order
};

/// All rows of `file`, or none if it is absent. A last line without its end was cut off by a crash and is removed from the file.
/// OutputError naming the line if another line is damaged.
std::vector<RunPoint> read_points(const std::filesystem::path& file);

/// Adds a row (and the header, if the file is new) and hands it to the operating system. OutputError if that fails.
void append_point(const std::filesystem::path& file, const RunPoint& point);

}  // namespace pencil
