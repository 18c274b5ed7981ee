// Launcher of kernels/trace_probing_rays.cl.
#pragma once

#include <vector>

#include "device/device_scene.h"
#include "device/features.h"
#include "pencils/probing_rays.h"

namespace pencil {

/// What each ray meets first, in their order; distance infinite if nothing.
std::vector<ProbingHit> trace_probing_rays(Kernels& kernels, const DeviceScene& scene, const std::vector<ProbingRay>& rays);

}  // namespace pencil
