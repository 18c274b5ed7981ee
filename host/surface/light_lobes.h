// Launcher of kernels/light_lobes.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"
#include "device/surfels.h"

namespace pencil {

/// Adds what the lobes of `chosen` surfels send back of all light samples to outgoing[3][capacity] [W m^-2 sr^-1], but for
/// the share of `chains` rays along the lobes of each (follow_surfels).
void light_lobes(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const Buffer<int>& chosen, int chains,
                 const LightSet& lights, Buffer<float>& outgoing);

}  // namespace pencil
