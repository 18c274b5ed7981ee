#include "converge/curve.h"

#include <algorithm>
#include <cmath>

namespace pencil {
namespace {

constexpr double steepest = 1.5, exponent_step = 0.01;  // exponents that are tried
constexpr double flat_slope = -0.05;                    // an error that falls by less than 11 % in ten times the time does not fall
constexpr double floor_share = 0.5;                     // of the last error, below which a floor is not seen
constexpr double significant = 8;                       // F(1, n - 3) at about the 5 % level for 6 to 8 points
constexpr double same_error = 1.05;                     // what fell below a level by more had no floor there
constexpr double same_time = 1.05;                      // ratio of times that are not told apart
constexpr double precision = 1e-3;                      // relative, of a measured error: residuals below it mean nothing

double interpolate(double x, double x0, double y0, double x1, double y1) {
    if (x0 == x1) return y1;
    const double fraction = (std::log(x) - std::log(x0)) / (std::log(x1) - std::log(x0));
    return std::exp(std::log(y0) + fraction * (std::log(y1) - std::log(y0)));
}

struct SquareFit {
    double floor2 = 0, coefficient2 = 0, residual = 0;
};

/// Least squares of (floor2 + coefficient2 * t^-2s) / e^2 - 1 with both at least 0.
SquareFit fit_squares(const Curve& curve, double exponent, bool with_floor) {
    double aa = 0, ab = 0, bb = 0, a1 = 0, b1 = 0;
    for (const CurvePoint& point : curve) {
        const double a = 1 / (point.error * point.error), b = a * std::pow(point.seconds, -2 * exponent);
        aa += a * a, ab += a * b, bb += b * b, a1 += a, b1 += b;
    }
    SquareFit fit{0, b1 / bb, 0};
    const double determinant = aa * bb - ab * ab;
    if (with_floor && determinant > 0) {
        const double floor2 = (a1 * bb - b1 * ab) / determinant, coefficient2 = (b1 * aa - a1 * ab) / determinant;
        if (floor2 > 0 && coefficient2 > 0)
            fit = {floor2, coefficient2, 0};
        else if (coefficient2 <= 0)
            fit = {a1 / aa, 0, 0};
    }
    for (const CurvePoint& point : curve) {
        const double model = fit.floor2 + fit.coefficient2 * std::pow(point.seconds, -2 * exponent);
        const double relative = model / (point.error * point.error) - 1;
        fit.residual += relative * relative;
    }
    return fit;
}

/// The best exponent and its fit.
std::pair<double, SquareFit> best_fit(const Curve& curve, double from, bool with_floor) {
    std::pair<double, SquareFit> best{from, fit_squares(curve, from, with_floor)};
    for (double exponent = from + exponent_step; exponent <= steepest; exponent += exponent_step) {
        const SquareFit fit = fit_squares(curve, exponent, with_floor);
        if (fit.residual < best.second.residual) best = {exponent, fit};
    }
    return best;
}

}  // namespace

Curve make_curve(std::vector<CurvePoint> points) {
    const auto unusable = [](const CurvePoint& point) {
        return !(point.seconds > 0 && point.error > 0 && std::isfinite(point.seconds) && std::isfinite(point.error));
    };
    points.erase(std::remove_if(points.begin(), points.end(), unusable), points.end());
    std::stable_sort(points.begin(), points.end(), [](const CurvePoint& a, const CurvePoint& b) { return a.seconds < b.seconds; });
    return points;
}

Reading error_at(const Curve& curve, double seconds) {
    if (curve.empty() || seconds > curve.back().seconds * same_time)
        return {Reading::Kind::not_reached, curve.empty() ? 0 : curve.back().seconds};
    if (seconds * same_time < curve.front().seconds) return {Reading::Kind::before_first, curve.front().seconds};
    seconds = std::clamp(seconds, curve.front().seconds, curve.back().seconds);
    const auto after = std::find_if(curve.begin(), curve.end(), [&](const CurvePoint& point) { return point.seconds >= seconds; });
    const auto before = after == curve.begin() ? after : after - 1;
    return {Reading::Kind::measured, interpolate(seconds, before->seconds, before->error, after->seconds, after->error)};
}

Reading time_to(const Curve& curve, double error) {
    const auto reached = std::find_if(curve.begin(), curve.end(), [&](const CurvePoint& point) { return point.error <= error; });
    if (reached == curve.end()) return {Reading::Kind::not_reached, curve.empty() ? 0 : curve.back().seconds};
    if (reached == curve.begin())
        return {reached->error == error ? Reading::Kind::measured : Reading::Kind::before_first, reached->seconds};
    const auto before = reached - 1;
    return {Reading::Kind::measured, interpolate(error, before->error, before->seconds, reached->error, reached->seconds)};
}

std::optional<PowerLaw> fit_power_law(const Curve& curve) {
    const double n = static_cast<double>(curve.size());
    double x = 0, y = 0, xx = 0, xy = 0;
    for (const CurvePoint& point : curve) {
        const double log_time = std::log(point.seconds), log_error = std::log(point.error);
        x += log_time, y += log_error, xx += log_time * log_time, xy += log_time * log_error;
    }
    const double determinant = n * xx - x * x;
    if (curve.size() < 2 || curve.front().seconds == curve.back().seconds || determinant <= 0) return {};
    const double slope = (n * xy - x * y) / determinant;
    return PowerLaw{slope, std::exp((y - slope * x) / n)};
}

std::optional<FloorFit> fit_floor(const Curve& curve) {
    const std::optional<PowerLaw> law = fit_power_law(curve);
    if (curve.size() < 4 || !law) return {};
    const double slowest = 0.05;  // slower decay next to a floor cannot be told from the floor
    const auto [exponent, fit] = best_fit(curve, slowest, true);
    FloorFit result{std::sqrt(fit.floor2), std::sqrt(fit.coefficient2), exponent, false};
    if (law->slope > flat_slope) {
        result.floor = std::sqrt(fit_squares(curve, 0, false).coefficient2);
        result.coefficient = 0;
        result.visible = true;
        return result;
    }
    const double n = static_cast<double>(curve.size());
    const double without = best_fit(curve, 0, false).second.residual, with = fit.residual + n * precision * precision;
    const bool explains = (without - with) / (with / (n - 3)) >= significant;
    result.visible = explains && result.floor >= floor_share * curve.back().error && result.floor <= same_error * curve.back().error;
    return result;
}

}  // namespace pencil
