#include "options/option.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <tuple>

#include "options/option_values.h"

namespace pencil {

namespace {

/// "light-samples" of "-l,--light-samples".
std::string long_name(const Option& option) {
    const std::size_t dashes = option.flag.rfind("--");
    return dashes == std::string::npos ? option.flag : option.flag.substr(dashes + 2);
}

}  // namespace

bool serves(const Option& option, const std::string& method) {
    return option.methods.empty() || (", " + option.methods + ",").find(" " + method + ",") != std::string::npos;
}

std::string methods_text(const Option& option) {
    if (option.methods.empty()) return "";
    return (option.methods.find(',') == std::string::npos ? "Method " : "Methods ") + option.methods + ": ";
}

std::string option_key(const Option& option) {
    std::string key = long_name(option);
    std::replace(key.begin(), key.end(), '-', '_');
    return key;
}

std::string header_name(const Option& option) {
    std::string name;
    for (const char c : long_name(option)) {
        const bool begins_word = !name.empty() && name.back() == '-';
        if (begins_word)
            name.back() = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        else
            name += c;
    }
    return name;
}

Option integer_option(const std::string& flag, int& value, int low, int high, const std::string& help) {
    return {flag,
            "N",
            fmt::format("{} to {}", low, high),
            std::to_string(value),
            help,
            "",
            [&value, low, high](const std::string& text) { value = static_cast<int>(parse_integer(text, low, high)); },
            [&value] { return OptionValue(std::int64_t{value}); }};
}

Option endless_option(const std::string& flag, int& value, int low, int high, const std::string& help) {
    return {
        flag,
        "K",
        fmt::format("auto, {} to {}", low, high),
        "the scene's max_depth",
        help,
        "",
        [&value, low, high](const std::string& text) { value = text == "auto" ? -1 : static_cast<int>(parse_integer(text, low, high)); },
        [&value] { return value < 0 ? OptionValue(std::string("auto")) : OptionValue(std::int64_t{value}); }};
}

Option real_option(const std::string& flag, double& value, double low, bool low_included, double high, const std::string& help) {
    const std::string accepted = (low_included ? "from " : "above ") + format_real(low) + " to " + format_real(high);
    return {flag,
            "X",
            accepted,
            format_real(value),
            help,
            "",
            [=, &value](const std::string& text) { value = parse_real(text, low, low_included, high); },
            [&value] { return OptionValue(value); }};
}

Option resolution_option(int& width, int& height, const std::string& otherwise) {
    return {"--resolution",
            "WxH",
            "",
            otherwise,
            "Size of the image in pixels",
            "",
            [&width, &height](const std::string& text) { std::tie(width, height) = parse_resolution(text); },
            [&width, &height] { return OptionValue(fmt::format("{}x{}", width, height)); }};
}

Option seed_option(std::uint64_t& seed) {
    return {"--seed",
            "S",
            "",
            std::to_string(seed),
            "Seed of the random numbers",
            "",
            [&seed](const std::string& text) { seed = parse_seed(text); },
            [&seed] { return OptionValue(seed); }};
}

Option list_option(const std::string& flag, std::vector<std::string>& chosen, const std::vector<std::string>& known,
                   const std::string& standard, const std::string& help, const std::vector<std::string>& only_named) {
    return {flag,
            "A,B",
            join(known) + ", or all" + (only_named.empty() ? "" : ", without " + join(only_named)) + ", or none",
            standard,
            help,
            "",
            [&chosen, known, only_named](const std::string& text) { chosen = parse_list(text, known, only_named); },
            [&chosen] { return OptionValue(chosen); }};
}

}  // namespace pencil
