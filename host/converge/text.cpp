#include "converge/text.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace pencil {

namespace {
const char* const no_break = "\u00a0";  // numbers stay with their units
}

std::string round_text(double value) {
    if (!std::isfinite(value)) {
        return "–";
    }
    std::array<char, 32> text{};
    const double magnitude = std::abs(value);
    if (magnitude >= 100) {
        std::snprintf(text.data(), text.size(), magnitude < 1e6 ? "%.0f" : "%.1e", value);
    } else if (magnitude >= 10) {
        std::snprintf(text.data(), text.size(), "%.0f", value);
    } else if (magnitude == 0 || magnitude >= 1e-3) {
        std::snprintf(text.data(), text.size(), "%.2g", value);
    } else {
        std::snprintf(text.data(), text.size(), "%.1e", value);
    }
    return text.data();
}

std::string percent_text(double value) { return round_text(100 * value) + no_break + "%"; }

std::string seconds_text(double seconds) { return round_text(seconds) + no_break + "s"; }

std::string factor_text(double factor) { return round_text(factor) + "×"; }

std::string html_text(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

}  // namespace pencil
