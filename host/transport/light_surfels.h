// Launcher of kernels/light_surfels.cl.
#pragma once

#include "transport/device_scene.h"
#include "transport/features.h"
#include "transport/pencil_set.h"
#include "transport/surfels.h"

namespace pencil {

/// Adds reflected direct light of the light samples, thesis alg. 6.2. `what` is the profiling key.
void light_surfels(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const LightSet& lights, Buffer<float>& outgoing,
                   const std::string& what, int stride = 1, int group = 1, uint seed = 0);

}  // namespace pencil
