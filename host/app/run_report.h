// What a render did, for the reader of the terminal (summary, --explain) and for programs (--stats).
#pragma once

#include <filesystem>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "app/commands.h"
#include "cl/device.h"
#include "image/write_image.h"
#include "options/render_result.h"

namespace pencil {

struct RunReport {
    std::string scene_fingerprint;
    DeviceInfo device;
    DeviceProfile profile;  // of the first device
    RenderOptions options;  // as used: bounces and film size resolved
    int width = 0, height = 0;
    std::vector<StageTime> stages;  // the render's and those of the program around it
    std::map<std::string, LaunchTimes> launches;
    double kernel_build_seconds = 0;
    RenderStats stats;
    std::vector<std::string> layers;
    std::vector<std::string> warnings;
    bool interrupted = false;
    double total_wall_seconds = 0;
};

/// Largest resident size of this process so far [bytes].
std::uint64_t peak_resident_bytes();

/// Table of stages, total, device, memory, bounces, files.
void print_summary(std::ostream& out, const RunReport& report, const std::vector<std::filesystem::path>& written);

/// Decisions and what was left out, one line each.
void print_explanation(std::ostream& out, const RunReport& report);

/// Everything that decides the pixels, for the file's header; with `times`, what the run took, too.
Metadata image_metadata(const RunReport& report, const RenderCommand& command, bool times);

/// Replaces `file` by the report as JSON; the keys are described in stats_json.cpp.
void write_stats(const std::filesystem::path& file, const RunReport& report, const RenderCommand& command);

}  // namespace pencil
