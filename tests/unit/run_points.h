// Measured points of the experiment, made up.
#pragma once

#include <cmath>

#include "converge/methods.h"
#include "converge/runs.h"

namespace pencil {

inline RunPoint point(const std::string& method, int budget, std::uint64_t seed, double seconds, double rel_mse = 0.01) {
    RunPoint run;
    run.method = method;
    run.budget = budget;
    run.seed = seed;
    run.seconds = seconds;
    run.rel_mse = rel_mse;
    run.rmse = run.lab_rms = std::sqrt(rel_mse);
    run.mean_ratio = 0.97;
    run.options = run_flags(method, budget);
    run.stages = {{"pencil density", seconds / 4}, {"direct light", seconds / 2}};
    return run;
}

}  // namespace pencil
