#include "converge/text.h"

#include <fmt/format.h>

#include <cmath>

namespace pencil {

std::string round_text(double value) {
    if (!std::isfinite(value)) return "–";
    const double magnitude = std::abs(value);
    if (magnitude >= 1e6 || (magnitude > 0 && magnitude < 1e-3)) return fmt::format("{:.1e}", value);
    return fmt::format(magnitude >= 10 ? "{:.0f}" : "{:.2g}", value);
}

// Numbers stay with their units: U+00A0.
std::string percent_text(double value) { return round_text(100 * value) + "\u00a0%"; }

std::string seconds_text(double seconds) { return round_text(seconds) + "\u00a0s"; }

std::string factor_text(double factor) { return round_text(factor) + "×"; }

}  // namespace pencil
