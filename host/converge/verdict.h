// Who is ahead: curves compared at equal time and at equal error.
#pragma once

#include <string>
#include <vector>

#include "converge/curve.h"

namespace pencil {

/// Leads below it are called level.
constexpr double level = 1.1;

struct NamedCurve {
    std::string name;
    Curve curve;
};

/// The errors of all curves at one time.
struct Verdict {
    double seconds = 0;
    std::vector<Reading> errors;  // one per curve
    int ahead = -1;               // curve with the smallest error, -1 if none is measured there
    int second = -1;              // the next, -1 if none
    double lead = 1;              // error of the second over that of the first
};
Verdict judge(const std::vector<NamedCurve>& curves, double seconds);

/// The times that curves need to one error.
struct TimesToError {
    double error = 0;
    std::vector<Reading> times;    // one per curve
    std::vector<double> speedups;  // time of the first curve over that of each; 0 where one of them is not measured
};
TimesToError times_to(const std::vector<NamedCurve>& curves, double error);

/// Round errors (1, 2, 5 times powers of ten), descending, that lie between the largest and the smallest of all curves.
std::vector<double> round_errors(const std::vector<NamedCurve>& curves);

}  // namespace pencil
