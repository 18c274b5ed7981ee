#include "util/format.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace pencil {

std::string format_size(std::uint64_t bytes) {
    const std::array<const char*, 5> units{"bytes", "KiB", "MiB", "GiB", "TiB"};
    double value = static_cast<double>(bytes);
    std::size_t unit = 0;
    for (; value >= 1024 && unit + 1 < units.size(); ++unit) value /= 1024;
    return fmt::format("{:.{}f} {}", value, unit == 0 ? 0 : 1, units[unit]);
}

std::string format_short(double value) { return fmt::format("{:.3g}", value); }

std::string format_fixed(double value, int digits) {
    return std::abs(value) < 1e9 ? fmt::format("{:.{}f}", value, digits) : fmt::format("{:.{}e}", value, digits);
}

std::string format_extent(int width, int height) { return fmt::format("{}x{}", width, height); }

std::string csv_quoted(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

}  // namespace pencil
