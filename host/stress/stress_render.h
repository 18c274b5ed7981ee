// What the stress cases measure images with.
#pragma once

#include "options/render_options.h"
#include "reference/path_tracer.h"
#include "render/render.h"
#include "scene/scene.h"
#include "stress/stress_case.h"

namespace pencil {

/// Thrown where a run was stopped: half an image is not judged.
struct StressStopped {};

/// Renders with what the case is run with. StressStopped.
RenderResult render(const Scene& scene, const RenderOptions& options, const StressRun& run);
ReferenceResult trace_paths(const Scene& scene, const ReferenceOptions& options, const StressRun& run);

/// No layers but the beauty, and few passes: cases are about extremes, not about noise.
RenderOptions stress_options(MethodName method);

/// Mean over all pixels and channels of the beauty.
double mean_of(const std::vector<Layer>& layers);
/// Root of the mean square difference of two beauties, the second times `factor`, relative to the mean.
double difference_of(const std::vector<Layer>& image, const std::vector<Layer>& other, double factor = 1);
/// Values of the beauty that are not finite.
double non_finite_of(const std::vector<Layer>& layers);
/// Largest distance of a value from `truth`, relative to it.
double error_of(const std::vector<Layer>& layers, double truth);

}  // namespace pencil
