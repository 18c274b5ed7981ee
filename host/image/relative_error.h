// The relative error that images are judged by: relMSE = mean((x - r)^2 / (r^2 + 0.01 m^2)), m the mean of the reference r.
#pragma once

namespace pencil {

/// Share of the mean's square in the denominator: black pixels do not decide the error.
constexpr double dark_share = 0.01;

/// The square that an error in a value `r` is relative to; `mean` is m.
inline double relative_to(double r, double mean) { return r * r + dark_share * mean * mean; }

/// The part of relMSE that one value adds, before averaging.
inline double relative_square(double x, double r, double mean) { return (x - r) * (x - r) / relative_to(r, mean); }

}  // namespace pencil
