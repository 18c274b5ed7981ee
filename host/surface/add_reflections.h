// Launcher of kernels/add_reflections.cl.
#pragma once

#include "surface/follow_surfels.h"

namespace pencil {

/// Adds to outgoing[3][capacity] of each surfel the mean of its chains' radiance: `shared` of them, one after the other, have the same start.
/// before: outgoing without the light of film pencils, beside which chains for bases count.
void add_reflections(Kernels& kernels, const Chains& chains, const Buffer<float>& radiance, const Buffer<int>& starts, int shared,
                     const Buffer<float>& before, int capacity, Buffer<float>& outgoing);

}  // namespace pencil
