// One run of the experiment: a render or a traced image, its time and its error.
#pragma once

#include <memory>
#include <optional>

#include "cl/device.h"
#include "converge/options.h"
#include "converge/run_plan.h"
#include "converge/truth.h"

namespace pencil {

struct TracedImage {
    std::vector<float> rgb;
    int spp = 0;
    double seconds = 0;  // wall clock, acceleration structure included
    bool interrupted = false;
};

/// The path tracer for `seconds`.
TracedImage trace_image(const Scene& scene, const ConvergeOptions& options, double seconds, std::uint64_t seed, const Progress& progress);

/// The options that make a run, as the command line spells them.
std::string run_flags(const std::string& method, int budget);

/// Image of a run, below the folder: "images/sets-3-0.exr".
std::filesystem::path image_file(const ConvergeOptions& options, const std::string& method, int budget, std::uint64_t seed);

/// Renders, measures and keeps the image. Nothing if `progress` stopped it. MemoryError if the run does not fit.
std::optional<RunPoint> run_task(const Task& task, const Scene& scene, const ConvergeOptions& options, const Truth& truth,
                                 const std::shared_ptr<Device>& device, const Progress& progress);

/// Renders each method's first step once, unrecorded: drivers compile kernels for their first launch, after the build.
void warm_up(const Scene& scene, const ConvergeOptions& options, const std::shared_ptr<Device>& device, const Progress& progress);

}  // namespace pencil
