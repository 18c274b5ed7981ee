// Quantities as a reader wants them.
#pragma once

#include <cstdint>
#include <string>

namespace pencil {

/// "12.5 MiB".
std::string format_size(std::uint64_t bytes);

/// Three significant digits.
std::string format_short(double value);

/// `digits` after the point; large numbers with an exponent.
std::string format_fixed(double value, int digits);

/// "320x240".
std::string format_extent(int width, int height);

/// A field of a CSV file between quotes (RFC 4180).
std::string csv_quoted(const std::string& text);

}  // namespace pencil
