// Launcher of kernels/transport_irradiance.cl.
#pragma once

#include "surface/link_surfels.h"

namespace pencil {

/// One bounce, P = Q K R on a fixed set of `count` pencils of n x n texels: adds 1 / n^2 sum albedo sum_j w_j source_j to target, and what
/// target then holds to total [W m^-2]. Surfels and links: n x n per pencil.
void transport_irradiance(Kernels& kernels, const Surfels& surfels, const SurfaceLinks& links, int count, int n,
                          const Buffer<float4>& source, Buffer<float4>& target, Buffer<float4>& total);

}  // namespace pencil
