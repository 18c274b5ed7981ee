// Luminous intensities of lights by direction, as kernels look them up (kernels/lib/light_profile.cl).
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace pencil {

/// Appends the table of a light: its own x axis, then PROFILE_ROWS angles to its axis for each of PROFILE_COLUMNS azimuths. Returns the first texel.
int add_profile_table(const PointLight& light, const LightProfile& profile, std::vector<std::uint64_t>& texels);

}  // namespace pencil
