#include "stress/stress_case.h"

#include <cmath>

namespace pencil {

Measurement near(const std::string& what, double value, double truth, double relative) {
    const double margin = relative * std::abs(truth);
    return {what, value, truth - margin, truth + margin};
}

Measurement below(const std::string& what, double value, double most) { return {what, value, 0, most}; }

}  // namespace pencil
