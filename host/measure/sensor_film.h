// Sensors as a row of pixels.
#pragma once

#include <vector>

#include "measure/sensors.h"

namespace pencil {

/// The scene with these sensors as its film, seen from their middle: coordinates are exact there.
Scene with_sensors(const Scene& scene, const std::vector<Sensor>& sensors);

}  // namespace pencil
