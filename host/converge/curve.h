// Error against time as a curve: what can be read off between measured points, and what law the points follow. Nothing is ever read off
// outside the measured range.
#pragma once

#include <optional>
#include <vector>

namespace pencil {

struct CurvePoint {
    double seconds = 0;
    double error = 0;
};

/// Sorted by time; times and errors are above 0.
using Curve = std::vector<CurvePoint>;

/// Drops points that are not finite or not above 0, and sorts by time.
Curve make_curve(std::vector<CurvePoint> points);

struct Reading {
    enum class Kind {
        measured,      // between two points: `value` by interpolation
        before_first,  // `value` is the first point's time: what was asked for lies before it, or is reached by then
        not_reached,   // `value` is the last point's time
    };
    Kind kind = Kind::not_reached;
    double value = 0;
};

/// The error at a time, linear between points on logarithmic scales. A time within 5 % of the first or last point's counts as it: a budget
/// of 10 s is kept to 9.98 s.
Reading error_at(const Curve& curve, double seconds);
/// The time at which the error first falls to `error`.
Reading time_to(const Curve& curve, double error);

/// error = coefficient * seconds^slope, least squares of log error over log time.
struct PowerLaw {
    double slope = 0;
    double coefficient = 0;
};
/// Nothing with fewer than two different times.
std::optional<PowerLaw> fit_power_law(const Curve& curve);

/// error^2 = floor^2 + (coefficient * seconds^-exponent)^2.
struct FloorFit {
    double floor = 0;
    double coefficient = 0;
    double exponent = 0;
    bool visible = false;
};
/// Least squares of relative residuals of error^2. `visible`: the curve does not fall at all (slope above -0.05), or the floor makes up at
/// least half of the last error, at most 5 % more than it, and explains the points significantly better than a power law. Nothing with
/// fewer than four points.
std::optional<FloorFit> fit_floor(const Curve& curve);

}  // namespace pencil
