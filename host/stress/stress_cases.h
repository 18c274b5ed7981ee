// The table of stress cases.
#pragma once

#include <vector>

#include "stress/stress_case.h"

namespace pencil {

/// All of them, group by group. A new case is a row in its group's file.
std::vector<StressCase> stress_cases();

std::vector<StressCase> light_cases();     // strength of light
std::vector<StressCase> stiff_cases();     // albedos near 1
std::vector<StressCase> geometry_cases();  // scales, slivers, coincidence
std::vector<StressCase> film_cases();      // sizes of films and maps, options at their ends
std::vector<StressCase> bound_cases();     // time
std::vector<StressCase> material_cases();  // surfaces at the ends of their parameters

}  // namespace pencil
