// The yardstick: a path tracer that shares the scene loader with the pencil renderer and nothing of its light transport. It casts rays
// with Embree, estimates direct light by next-event estimation and BRDF sampling combined by multiple importance sampling, and ends
// paths by Russian roulette; its expectation is the exact solution for the scene's triangles.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "options/layer.h"
#include "options/reference_options.h"
#include "scene/scene.h"

namespace pencil {

struct ReferenceResult {
    int width = 0, height = 0;
    std::vector<Layer> layers;  // beauty first
    int spp = 0;                // camera paths that every pixel has
    std::vector<int> sets;      // of each pixel: independent sets of paths, two of which tell a variance
    std::uint64_t paths = 0, rays = 0;
    double estimated_error = 0;  // relMSE of the beauty, from the spread of independent sets of paths; infinite if there are too few
    double trace_seconds = 0, build_seconds = 0;  // wall clock: tracing; normalising the scene and building the BVH
    bool interrupted = false;                     // stopped early: the layers hold what was finished
    std::vector<std::string> warnings;
};

/// Called now and then, from any thread but never from two at once; `fraction` in [0, 1] of the stage. Return false to stop early.
using ReferenceProgress = std::function<bool(const std::string& stage, double fraction)>;

/// Equal scene, options and seed give equal bits whatever the number of threads, unless a time budget decides. UsageError for options
/// out of range, MemoryError if Embree cannot get memory.
ReferenceResult trace_paths(const Scene& scene, const ReferenceOptions& options, const ReferenceProgress& progress = {});

}  // namespace pencil
