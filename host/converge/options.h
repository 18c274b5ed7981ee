// What `pencil converge` was asked to measure.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pencil {

struct ConvergeOptions {
    std::filesystem::path scene;      // for titles and messages
    std::filesystem::path reference;  // empty: made by the path tracer and kept in `folder`
    std::filesystem::path folder;
    std::vector<std::string> methods;  // beside the path tracer
    int seeds = 3;
    double longest = 10;        // [s] where ladders end, see RunPlan
    int width = 0, height = 0;  // [pixels]
    int bounces = -1;           // reflections at most, direct light included; -1: no limit
    std::string version;        // of the program
    std::string command;        // that repeats the measurement, for the page
};

/// The number of reflections as a text: "auto" or "4".
inline std::string bounces_text(const ConvergeOptions& options) { return options.bounces < 0 ? "auto" : std::to_string(options.bounces); }

}  // namespace pencil
