// std::from_chars throughout: it knows no locale, no leading blanks and no partial numbers.
#include "options/option_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace pencil {
namespace {

template <typename T>
bool reads_as(const std::string& text, T& value) {
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc() && stop == end;
}

[[noreturn]] void reject(const std::string& text, const std::string& wanted) {
    throw std::invalid_argument("\"" + text + "\" is not " + wanted);
}

constexpr int largest_side = 1000000;  // [pixels]; what fits into memory is judged later, with the layers

}  // namespace

std::int64_t parse_integer(const std::string& text, std::int64_t low, std::int64_t high) {
    std::int64_t value = 0;
    if (!reads_as(text, value) || value < low || value > high) reject(text, fmt::format("an integer from {} to {}", low, high));
    return value;
}

std::uint64_t parse_seed(const std::string& text) {
    std::uint64_t value = 0;
    if (!reads_as(text, value)) reject(text, "an integer from 0 to 18446744073709551615");
    return value;
}

double parse_real(const std::string& text, double low, bool low_included, double high) {
    double value = 0;
    const bool valid = reads_as(text, value) && std::isfinite(value) && value <= high && (value > low || (low_included && value == low));
    if (!valid) {
        const std::string from = low_included ? "a number from " : "a number above ";
        reject(text, from + format_real(low) + (low_included ? " to " : " and at most ") + format_real(high));
    }
    return value;
}

std::pair<int, int> parse_resolution(const std::string& text) {
    const std::size_t cross = std::min(text.find_first_of("xX"), text.size());
    int width = 0, height = 0;
    const bool numbers = reads_as(text.substr(0, cross), width) && reads_as(text.substr(std::min(cross + 1, text.size())), height);
    if (!numbers || std::min(width, height) < 1 || std::max(width, height) > largest_side)
        reject(text, fmt::format("WIDTHxHEIGHT with both from 1 to {}", largest_side));
    return {width, height};
}

std::pair<std::string, std::string> parse_define(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos) reject(text, "name=value");
    return {text.substr(0, equals), text.substr(equals + 1)};
}

std::vector<std::string> parse_list(const std::string& text, const std::vector<std::string>& known,
                                    const std::vector<std::string>& only_named) {
    const auto holds = [](const std::vector<std::string>& words, const std::string& word) {
        return std::find(words.begin(), words.end(), word) != words.end();
    };
    std::vector<std::string> wanted;
    bool all = false;
    for (std::size_t start = 0; text != "none" && start <= text.size();) {
        const std::size_t comma = std::min(text.find(',', start), text.size());
        wanted.push_back(text.substr(start, comma - start));
        all = all || wanted.back() == "all";
        if (wanted.back() != "all" && !holds(known, wanted.back())) reject(wanted.back(), "one of " + join(known) + ", or all, or none");
        start = comma + 1;
    }
    std::vector<std::string> ordered;
    std::copy_if(known.begin(), known.end(), std::back_inserter(ordered),
                 [&](const std::string& name) { return holds(wanted, name) || (all && !holds(only_named, name)); });
    return ordered;
}

std::size_t parse_choice(const std::string& text, const std::vector<std::string>& known) {
    const auto found = std::find(known.begin(), known.end(), text);
    if (found == known.end()) reject(text, "one of " + join(known));
    return static_cast<std::size_t>(found - known.begin());
}

std::vector<std::size_t> parse_mixture(const std::string& text, const std::vector<std::string>& known) {
    std::vector<std::size_t> members;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t plus = std::min(text.find('+', start), text.size());
        const std::size_t member = parse_choice(text.substr(start, plus - start), known);
        if (std::find(members.begin(), members.end(), member) != members.end())
            throw std::invalid_argument("\"" + text + "\" names " + known[member] + " twice");
        members.push_back(member);
        start = plus + 1;
    }
    return members;
}

std::string join(const std::vector<std::string>& parts) {
    std::string joined;
    for (const std::string& part : parts) joined += (joined.empty() ? "" : ", ") + part;
    return joined;
}

std::string format_real(double value) {
    char text[32];
    return std::string(text, std::to_chars(text, text + sizeof(text), value).ptr);
}

}  // namespace pencil
