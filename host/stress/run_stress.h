// Runs stress cases and judges them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "stress/stress_case.h"

namespace pencil {

/// Every case ends within this time on a machine of two cores [s].
constexpr double stress_seconds = 30;

enum class Verdict { holds, fails };

struct StressResult {
    StressCase row;
    std::vector<Measurement> measured;  // the time the last of them
    std::string error;                  // that ended it, empty if none did
    double seconds = 0;                 // without kernel builds; of wall clock and processor time the lesser: others may use the machine
    Verdict verdict = Verdict::fails;
    bool stopped = false;  // by `progress`: there is no verdict
};

/// "holds", "FAILS".
std::string to_string(Verdict verdict);

/// What ends a case with an error is part of the result, and so is what takes too long.
StressResult run_case(const StressCase& row, const std::shared_ptr<Device>& device, const Progress& progress = {});

}  // namespace pencil
