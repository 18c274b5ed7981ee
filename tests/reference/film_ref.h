// Reconstruction filters as Mitsuba documents them, one-dimensional, not normalised; a film weights by f(dx) f(dy). Double precision.
#pragma once

#include <algorithm>
#include <cmath>

#include "reference/octahedral_ref.h"

namespace pencil::ref {

inline double box_filter(double x, double radius = 0.5) { return std::abs(x) <= radius ? 1.0 : 0.0; }

inline double tent_filter(double x, double radius = 1.0) { return std::max(0.0, 1.0 - std::abs(x) / radius); }

/// Lowered so that it ends at 0: exp(-x^2 / 2 s^2) - exp(-r^2 / 2 s^2). Mitsuba's radius is 4 s.
inline double gaussian_filter(double x, double stddev = 0.5, double radius = 2.0) {
    const double alpha = -1.0 / (2.0 * stddev * stddev);
    return std::max(0.0, std::exp(alpha * x * x) - std::exp(alpha * radius * radius));
}

/// Mitchell & Netravali 1988, support 2.
inline double mitchell_filter(double x, double b = 1.0 / 3.0, double c = 1.0 / 3.0) {
    const double t = std::abs(x);
    if (t < 1.0) return ((12.0 - 9.0 * b - 6.0 * c) * t * t * t + (-18.0 + 12.0 * b + 6.0 * c) * t * t + (6.0 - 2.0 * b)) / 6.0;
    if (t < 2.0)
        return ((-b - 6.0 * c) * t * t * t + (6.0 * b + 30.0 * c) * t * t + (-12.0 * b - 48.0 * c) * t + (8.0 * b + 24.0 * c)) / 6.0;
    return 0.0;
}

inline double catmullrom_filter(double x) { return mitchell_filter(x, 0.0, 0.5); }

/// Sinc windowed by the main lobe of a wider sinc; the radius is the number of lobes.
inline double lanczos_filter(double x, double lobes = 3.0) {
    const double t = std::abs(x);
    if (t >= lobes) return 0.0;
    if (t < 1e-9) return 1.0;  // sin(x)/x to double precision
    return std::sin(pi * t) / (pi * t) * (std::sin(pi * t / lobes) / (pi * t / lobes));
}

}  // namespace pencil::ref
