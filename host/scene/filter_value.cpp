#include "scene/filter_value.h"

#include <algorithm>
#include <cmath>

#include "util/constants.h"

namespace pencil {

namespace {

double sinc(double x) { return x == 0 ? 1.0 : std::sin(pi * x) / (pi * x); }

/// Mitchell and Netravali 1988, on [-2, 2].
double mitchell(double x, double b, double c) {
    x = std::abs(x);
    if (x < 1) return ((12 - 9 * b - 6 * c) * x * x * x + (-18 + 12 * b + 6 * c) * x * x + (6 - 2 * b)) / 6;
    if (x < 2) return ((-b - 6 * c) * x * x * x + (6 * b + 30 * c) * x * x + (-12 * b - 48 * c) * x + (8 * b + 24 * c)) / 6;
    return 0;
}

}  // namespace

double filter_value(const ReconstructionFilter& f, double x) {
    const double a = std::abs(x);
    using Kind = ReconstructionFilter::Kind;
    if (f.kind == Kind::box) return x >= -f.radius && x < f.radius ? 1.0 : 0.0;
    if (a > f.radius) return 0.0;
    switch (f.kind) {
        case Kind::tent:
            return std::max(1.0 - a / f.radius, 0.0);
        case Kind::gaussian: {
            const double alpha = -0.5 / (f.stddev * f.stddev);
            return std::max(std::exp(alpha * a * a) - std::exp(alpha * f.radius * f.radius), 0.0);
        }
        case Kind::mitchell:
            return mitchell(2 * a / f.radius, f.b, f.c);
        case Kind::catmullrom:
            return mitchell(2 * a / f.radius, 0.0, 0.5);
        case Kind::lanczos:
            return sinc(a) * sinc(a / f.radius);
        default:
            return 0.0;
    }
}

}  // namespace pencil
