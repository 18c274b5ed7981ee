// The environment as kernels see it, and the part of it that is sampled as lights.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "shared/light.h"
#include "shared/sky.h"

namespace pencil {

/// Texels of the environment row by row, its description without the density of light samples; nothing without an environment. `light`: unit
/// of radiance.
Sky flatten_sky(const Scene& scene, std::vector<float4>& texels, double light = 1.0);

/// The same of one texel.
double sampled_texel_power(const Sky& sky, const std::vector<float4>& texels, std::size_t texel);

/// What of the environment light samples carry, integrated over directions: luminance above the limit [W m^-2].
double sampled_sky_power(const Sky& sky, const std::vector<float4>& texels);

/// `count` samples of what exceeds the limit, stratified; sets of one seed in successive turns differ.
void sample_sky(const Sky& sky, const std::vector<float4>& texels, int count, std::uint64_t seed, std::uint64_t turn,
                std::vector<LightSample>& samples);

}  // namespace pencil
