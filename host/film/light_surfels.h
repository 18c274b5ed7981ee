// Launcher of kernels/light_surfels.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"
#include "device/surfels.h"

namespace pencil {

/// Adds reflected direct light of the light samples, thesis alg. 6.2. `what` is the profiling key.
void light_surfels(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const LightSet& lights, Buffer<float>& outgoing,
                   const std::string& what);

}  // namespace pencil
