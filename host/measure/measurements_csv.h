// Measurements as a table.
#pragma once

#include <string>
#include <vector>

#include "measure/measure.h"

namespace pencil {

/// A line of names, then one for each sensor: name, position, normal (of a meter: none), illuminance with the ends of its 95 % interval, direct
/// and indirect part [lx].
std::string measurements_csv(const std::vector<Sensor>& sensors, const Measurements& measurements);

}  // namespace pencil
