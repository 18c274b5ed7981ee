// Launcher of kernels/emit_chains.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/surfels.h"

namespace pencil {

/// Adds emission that chains end on to radiance[3][capacity] [W m^-2 sr^-1].
void emit_chains(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, Buffer<float>& radiance);

}  // namespace pencil
