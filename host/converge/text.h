// Numbers as the page's reader wants them.
#pragma once

#include <string>

namespace pencil {

/// Two significant digits, without exponent where it stays short: "0.013", "4.2", "120".
std::string round_text(double value);
/// "4.2 %" of 0.042.
std::string percent_text(double value);
/// "0.25 s".
std::string seconds_text(double seconds);
/// "3.1x" with the multiplication sign.
std::string factor_text(double factor);

}  // namespace pencil
