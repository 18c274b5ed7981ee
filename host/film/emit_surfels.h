// Launcher of kernels/emit_surfels.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/surfels.h"

namespace pencil {

/// Adds emitted radiance; `carried_only`: only of emitters of LightForm::maps.
void emit_surfels(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, bool carried_only, Buffer<float>& radiance);

}  // namespace pencil
