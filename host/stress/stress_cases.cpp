#include "stress/stress_cases.h"

#include <iterator>

namespace pencil {

std::vector<StressCase> stress_cases() {
    std::vector<StressCase> all;
    for (std::vector<StressCase> (*group)() : {light_cases, stiff_cases, geometry_cases, film_cases, material_cases, bound_cases}) {
        std::vector<StressCase> rows = group();
        std::move(rows.begin(), rows.end(), std::back_inserter(all));
    }
    return all;
}

}  // namespace pencil
