// Launcher of kernels/sample_lights.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"
#include "device/surfels.h"
#include "surface/viewers.h"

namespace pencil {

/// Adds reflected direct light to outgoing[3][capacity] [W m^-2 sr^-1]: in the mean what light_surfels adds, by `draws` samples for every 16 surfels
/// out of every stride-th three; needs the scene's hierarchy. `viewers`: who sees the surfels, so that what is drawn does not depend on what else
/// is lit at once.
void sample_lights(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const LightSet& lights, int stride, int draws,
                   uint seed, Buffer<float>& outgoing, const std::optional<Viewers>& viewers = {});

}  // namespace pencil
