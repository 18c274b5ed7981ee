// Texts to values, each with a message that says what is accepted.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pencil {

/// All throw std::invalid_argument; the message completes "--option: ".
std::int64_t parse_integer(const std::string& text, std::int64_t low, std::int64_t high);
std::uint64_t parse_seed(const std::string& text);
/// `low` itself is accepted only if `low_included`.
double parse_real(const std::string& text, double low, bool low_included, double high);
/// "512x384" to width and height.
std::pair<int, int> parse_resolution(const std::string& text);
/// "name=value".
std::pair<std::string, std::string> parse_define(const std::string& text);
/// "a,b", "all", "all,c" or "none" to a list without duplicates, in the order of `known`. All are those that are not `only_named`.
std::vector<std::string> parse_list(const std::string& text, const std::vector<std::string>& known,
                                    const std::vector<std::string>& only_named = {});
/// The position of `text` in `known`.
std::size_t parse_choice(const std::string& text, const std::vector<std::string>& known);
/// "a" or "a+b+c", each once, to their positions in `known`, in the order of the text.
std::vector<std::size_t> parse_mixture(const std::string& text, const std::vector<std::string>& known);

/// "a, b, c".
std::string join(const std::vector<std::string>& parts);
/// The shortest text that reads back as `value`.
std::string format_real(double value);

}  // namespace pencil
