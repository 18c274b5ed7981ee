// Sensors as a row of pixels, and back.
#pragma once

#include <vector>

#include "measure/sensors.h"
#include "options/layer.h"

namespace pencil {

/// The scene with these sensors as its film, seen from their middle: coordinates are exact there.
Scene with_sensors(const Scene& scene, const std::vector<Sensor>& sensors);

/// `factor` times the luminance of each pixel of rgb; of standard errors, too, where channels err alike.
std::vector<double> pixel_luminances(const std::vector<float>& rgb, double factor);

}  // namespace pencil
