// What `pencil reference` did, for the reader of the terminal, for programs (--stats) and for the header of the image.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "app/commands.h"
#include "image/write_image.h"
#include "reference/path_tracer.h"

namespace pencil {

struct ReferenceReport {
    std::string scene_fingerprint;
    ReferenceOptions options;    // as used: depth and film size resolved
    ReferenceResult result;      // its layers may have been moved away
    double lumens_per_watt = 0;  // as used
    std::vector<std::string> layers, warnings;
    double load_seconds = 0, write_seconds = 0, total_seconds = 0;
};

void print_summary(std::ostream& out, const ReferenceReport& report, const std::vector<std::filesystem::path>& written);

/// Everything that decides the pixels; with `times`, what the run took, too.
Metadata image_metadata(const ReferenceReport& report, const ReferenceCommand& command, bool times);

/// Replaces `file` by the report as JSON; the keys are described in reference_report.cpp.
void write_stats(const std::filesystem::path& file, const ReferenceReport& report, const ReferenceCommand& command);

}  // namespace pencil
