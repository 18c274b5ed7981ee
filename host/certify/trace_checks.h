// Launcher of kernels/trace_checks.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/surfels.h"
#include "shared/emitter.h"

namespace pencil {

/// Emitters in device memory.
struct CheckLights {
    auto list() const { return std::tie(emitters, count, densities, sky_density); }

    Buffer<Emitter> emitters;
    int count = 0;
    Buffer<float> densities;  // as in EmitterTable,
    float sky_density = 0;    // as this
};

/// One light path from each of `starts` (surfels, -1: none): radiance[3][starts] is what it finds that the surfel sends to the eye, emission
/// and `orders` reflections (-1: all) [W m^-2 sr^-1]. Needs the scene's hierarchy.
void trace_checks(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const Buffer<int>& starts, const CheckLights& lights,
                  int orders, uint seed, Buffer<float>& radiance);

}  // namespace pencil
