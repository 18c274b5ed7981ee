// Checkpoints: files from which a render that was killed goes on, as if it had never stopped. Written beside the old one and renamed, so that
// there is a whole one at any moment.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "cl/device.h"
#include "options/render_options.h"
#include "scene/scene.h"
#include "util/stopwatch.h"

namespace pencil {

/// What must be equal where a render goes on, by name, in the order in which differences are reported.
using RenderIdentity = std::vector<std::pair<std::string, std::string>>;

/// `options`: resolved. When to stop is no part of it: a render may go on for longer.
RenderIdentity render_identity(const Scene& scene, const RenderOptions& options, const Device& device);

/// Replaces `file`. OutputError.
void write_checkpoint(const std::filesystem::path& file, const RenderIdentity& identity, const std::vector<char>& state);

/// The state. UsageError where the file cannot be read, is no checkpoint, is damaged, or belongs to another render: it says how that differs.
std::vector<char> read_checkpoint(const std::filesystem::path& file, const RenderIdentity& identity);

/// Says when it is time for the next checkpoint: they take a fiftieth of the time at most.
class CheckpointClock {
public:
    bool due() const { return since_.seconds() >= least_pause_; }
    void written_in(double seconds);

private:
    Stopwatch since_;
    double least_pause_ = 0;  // [s]
};

}  // namespace pencil
