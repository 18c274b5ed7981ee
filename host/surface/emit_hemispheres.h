// Launcher of kernels/emit_hemispheres.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/surfels.h"
#include "surface/viewers.h"

namespace pencil {

/// Adds to radiance[3][capacity] [W m^-2 sr^-1] the emission that viewers see in their surfels, from surfel 0 on:
/// (A/pi) / (r^2 + A/pi) of it, with A/pi = near_area[material] [scene units^2] (near_areas), INFINITY for emitters without light samples.
void emit_hemispheres(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const Viewers& viewers,
                      const Buffer<float>& near_area, Buffer<float>& radiance);

}  // namespace pencil
