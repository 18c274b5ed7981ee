// Launcher of kernels/project_pencils.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"
#include "device/surfels.h"
#include "line/weights.h"

namespace pencil {

/// Adds the radiance of `set` reflected by the surfels, thesis alg. 6.3; `visible` gets the number of pencils each surfel sees.
/// `what` is the profiling key: "pencil transport" or "projection-scatter".
void project_pencils(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const PencilSet& set, WeightTables& weights,
                     Buffer<float>& outgoing, Buffer<int>& visible, const std::string& what);

/// The same for surfels `first` to `end`, `first` a multiple of surfel_multiple.
void project_pencils(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, int first, int end, const PencilSet& set,
                     WeightTables& weights, Buffer<float>& outgoing, Buffer<int>& visible, const std::string& what);

}  // namespace pencil
