// The measured numbers of a run by their names in runs.jsonl and points.csv, in the order of columns.
#pragma once

#include <array>

#include "converge/points.h"

namespace pencil {

struct RunField {
    const char* key;
    double RunPoint::*value;
};

constexpr std::array<RunField, 7> run_fields{{{"seconds", &RunPoint::seconds},
                                              {"build_seconds", &RunPoint::build_seconds},
                                              {"rmse", &RunPoint::rmse},
                                              {"rel_mse", &RunPoint::rel_mse},
                                              {"mean_ratio", &RunPoint::mean_ratio},
                                              {"psnr_db", &RunPoint::psnr},
                                              {"lab_rms", &RunPoint::lab_rms}}};

}  // namespace pencil
