// Finished runs: kept in runs.jsonl, one JSON object a line in a file that only ever grows, which is what an interruption must not lose
// and what a later run goes on from; and as a table for readers, points.csv.
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
    std::vector<std::pair<std::string, double>> stages;  // name and wall seconds, in order; names differ
};

struct RunLog {
    std::vector<RunPoint> points;
    std::string warning;  // of a last line that was cut off by a crash; empty: none
};

/// All lines of `file`, or none if it is absent; a last line without its end is left out. OutputError naming the line if another line is
/// not a run of this version.
RunLog read_runs(const std::filesystem::path& file);

/// Adds a line and hands it to the operating system; a last line without its end is removed before. OutputError if that fails.
void append_run(const std::filesystem::path& file, const RunPoint& point);

/// A header and one row for each run (RFC 4180).
std::string points_csv(const std::vector<RunPoint>& points);

}  // namespace pencil
