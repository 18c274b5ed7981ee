// Launcher of kernels/add_reflections.cl.
#pragma once

#include "device/features.h"
#include "device/surfels.h"

namespace pencil {

/// Adds to outgoing[3][capacity] of each surfel the mean of its chains' radiance: `shared` of them, one after the other, have the same start.
void add_reflections(Kernels& kernels, const Buffer<float>& radiance, const Surfels& chains, const Buffer<int>& starts, int shared,
                     int capacity, Buffer<float>& outgoing);

}  // namespace pencil
