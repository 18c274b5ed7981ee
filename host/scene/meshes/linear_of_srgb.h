// Colours of vertices as meshes give them: as a screen shows them, by the curve of sRGB.
#pragma once

#include <algorithm>
#include <cmath>

namespace pencil {

/// IEC 61966-2-1, for values clamped to [0, 1].
inline float linear_of_srgb(double value) {
    const double v = std::clamp(value, 0.0, 1.0);
    return static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
}

}  // namespace pencil
