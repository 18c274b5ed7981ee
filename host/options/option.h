// One option: all that anyone needs to know of it. Command line, documentation, --stats and image headers are written from lists of these;
// there is no other place that knows an option's name, range or default.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "options/option_values.h"

namespace pencil {

/// As it stands in JSON and in image headers; monostate: not given.
using OptionValue = std::variant<std::monostate, std::int64_t, std::uint64_t, double, std::string, std::vector<std::string>>;

struct Option {
    std::string flag;                              // "--light-samples", "-o,--output", or "SCENE" for a positional one
    std::string value;                             // what stands for the value in help, "N"; empty for a switch
    std::string accepted;                          // range or words: "1 to 1048576", "direct, emission, auto"; may be empty
    std::string standard;                          // the default as text; may be empty
    std::string help;                              // one sentence without a full stop
    std::string methods;                           // those that know it, ", " between them; empty: all
    std::function<void(const std::string&)> read;  // throws std::invalid_argument, which completes "--flag: "; a switch reads ""
    std::function<OptionValue()> show;             // what it is now; empty: not part of --stats and image headers
    bool required = false, repeated = false;
};

/// Whether a method knows it.
bool serves(const Option& option, const std::string& method);
/// "Method surface: ", "Methods line, hybrid: ", or nothing.
std::string methods_text(const Option& option);
/// "light_samples" of "--light-samples": its key in --stats.
std::string option_key(const Option& option);
/// "lightSamples": its name in image headers, behind "pencil:".
std::string header_name(const Option& option);

/// Rows for common kinds of values. `value` must live as long as the row.
Option integer_option(const std::string& flag, int& value, int low, int high, const std::string& help);
/// An integer from `low` to `high`, or auto, which is -1: no limit. Not given: the scene's max_depth.
Option endless_option(const std::string& flag, int& value, int low, int high, const std::string& help);
/// Above `low`, or from it on if `low_included`, up to `high`.
Option real_option(const std::string& flag, double& value, double low, bool low_included, double high, const std::string& help);
Option resolution_option(int& width, int& height, const std::string& otherwise);
Option seed_option(std::uint64_t& seed);
/// Words out of `known`, separated by commas; `standard`: what `chosen` holds now, in words. "all" stands for those that are not `only_named`.
Option list_option(const std::string& flag, std::vector<std::string>& chosen, const std::vector<std::string>& known,
                   const std::string& standard, const std::string& help, const std::vector<std::string>& only_named = {});
/// `value` as one of `words`, which stand in the order of the enumeration.
template <typename Enum>
Option word_option(const std::string& flag, Enum& value, const std::vector<std::string>& words, const std::string& help) {
    const auto word = [&value, words] { return words[static_cast<std::size_t>(value)]; };
    return {flag,
            "WORD",
            join(words),
            word(),
            help,
            "",
            [&value, words](const std::string& text) { value = static_cast<Enum>(parse_choice(text, words)); },
            [word] { return OptionValue(word()); }};
}

}  // namespace pencil
