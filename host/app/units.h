// Quantities as a reader wants them.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

namespace pencil {

/// "12.5 MiB".
inline std::string format_size(std::uint64_t bytes) {
    const char* const units[] = {"bytes", "KiB", "MiB", "GiB", "TiB"};
    double value = static_cast<double>(bytes);
    int unit = 0;
    for (; value >= 1024 && unit < 4; ++unit) {
        value /= 1024;
    }
    char text[48];
    std::snprintf(text, sizeof(text), unit == 0 ? "%.0f %s" : "%.1f %s", value, units[unit]);
    return text;
}

/// Three significant digits.
inline std::string format_short(double value) {
    char text[32];
    std::snprintf(text, sizeof(text), "%.3g", value);
    return text;
}

/// `digits` after the point.
inline std::string format_fixed(double value, int digits) {
    char text[64];
    std::snprintf(text, sizeof(text), std::abs(value) < 1e9 ? "%.*f" : "%.*e", digits, value);
    return text;
}

}  // namespace pencil
