// std::from_chars does the reading: it knows no locale, and it stops at the first wrong character, which is then an error.
#include "scene/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numeric>
#include <stdexcept>

namespace pencil {
namespace {

constexpr std::string_view blanks = " \t\r\n\f\v";

/// Length of the UTF-8 sequence that `text` begins with, 0 if it is not one (overlong and surrogate forms included).
std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x80) return 1;
    const std::size_t length = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
    if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0) != 0x80) return 0;
    if ((byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xED && byte(1) > 0x9F)) return 0;
    if ((byte(0) == 0xF0 && byte(1) < 0x90) || (byte(0) == 0xF4 && byte(1) > 0x8F)) return 0;
    return length;
}

bool is_control(std::string_view sequence) {
    const auto first = static_cast<unsigned char>(sequence[0]);
    if (sequence.size() == 1) return first < 0x20 || first == 0x7F;
    return first == 0xC2 && static_cast<unsigned char>(sequence[1]) < 0xA0;  // U+0080 to U+009F
}

/// from_chars takes no plus sign; numbers in files may carry one.
std::string_view without_plus(std::string_view text) { return text.size() > 1 && text[0] == '+' && text[1] != '-' ? text.substr(1) : text; }

}  // namespace

std::string escaped(std::string_view text, std::size_t limit) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        if (result.size() >= limit) return result + "...";
        const std::size_t length = utf8_length(text.substr(i));
        const std::string_view sequence = text.substr(i, std::max<std::size_t>(length, 1));
        if (length == 0 || is_control(sequence)) {
            for (const char c : sequence) {
                char code[8];
                std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned>(static_cast<unsigned char>(c)));
                result += code;
            }
        } else {
            result += sequence;
        }
        i += sequence.size();
    }
    return result;
}

std::string in_quotes(std::string_view text) { return '"' + escaped(text) + '"'; }

bool is_utf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = utf8_length(text.substr(i, 4));
        if (length == 0) return false;
        i += length;
    }
    return true;
}

namespace {

void append_utf8(std::string& text, std::uint32_t code) {
    const auto byte = [&](std::uint32_t value) { text += static_cast<char>(value); };
    if (code < 0x80) return byte(code);
    if (code < 0x800) {
        byte(0xC0 | code >> 6);
    } else {
        if (code < 0x10000) {
            byte(0xE0 | code >> 12);
        } else {
            byte(0xF0 | code >> 18);
            byte(0x80 | (code >> 12 & 0x3F));
        }
        byte(0x80 | (code >> 6 & 0x3F));
    }
    byte(0x80 | (code & 0x3F));
}

/// Without the mark. Half of a pair becomes a question mark.
std::string from_utf16(std::string_view text, bool big_endian) {
    const auto unit = [&](std::size_t at) -> std::uint32_t {
        const auto first = static_cast<unsigned char>(text[at]), second = static_cast<unsigned char>(text[at + 1]);
        return big_endian ? first * 256U + second : second * 256U + first;
    };
    std::string result;
    for (std::size_t at = 2; at + 1 < text.size(); at += 2) {
        std::uint32_t code = unit(at);
        const bool opens_pair = code >= 0xD800 && code < 0xDC00 && at + 3 < text.size();
        if (opens_pair && unit(at + 2) >= 0xDC00 && unit(at + 2) < 0xE000) {
            code = 0x10000 + ((code - 0xD800) << 10) + (unit(at + 2) - 0xDC00);
            at += 2;
        } else if (code >= 0xD800 && code < 0xE000) {
            code = '?';
        }
        append_utf8(result, code);
    }
    return result;
}

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

bool has_utf16_mark(std::string_view text) { return text.substr(0, 2) == "\xFF\xFE" || text.substr(0, 2) == "\xFE\xFF"; }

}  // namespace

bool has_encoding_mark(std::string_view text) { return has_utf16_mark(text) || text.substr(0, utf8_mark.size()) == utf8_mark; }

std::string decoded_by_mark(std::string_view text) {
    if (has_utf16_mark(text)) return from_utf16(text, text[0] == '\xFE');
    return std::string(has_encoding_mark(text) ? text.substr(utf8_mark.size()) : text);
}

std::string as_utf8(std::string text) {
    if (has_utf16_mark(text)) return decoded_by_mark(text);
    if (is_utf8(text)) return text;
    std::string result;
    for (const char c : text) append_utf8(result, static_cast<unsigned char>(c));
    return result;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view first_statement(std::string_view head) {
    while (!head.empty()) {
        const std::size_t end = std::min(head.find('\n'), head.size());
        const std::string_view line = trimmed(head.substr(0, end));
        if (!line.empty() && line[0] != '#') return line;
        head.remove_prefix(std::min(end + 1, head.size()));
    }
    return {};
}

std::vector<std::string_view> tokens(std::string_view text) {
    constexpr std::string_view separators = " \t\r\n\f\v,";
    std::vector<std::string_view> result;
    for (std::size_t i = text.find_first_not_of(separators); i != std::string_view::npos;) {
        const std::size_t end = std::min(text.find_first_of(separators, i), text.size());
        result.push_back(text.substr(i, end - i));
        i = text.find_first_not_of(separators, end);
    }
    return result;
}

std::optional<double> parse_number(std::string_view text) {
    text = without_plus(trimmed(text));
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<long long> parse_integer(std::string_view text) {
    text = without_plus(trimmed(text));
    long long value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

bool is_no_number(std::string_view text) {
    const std::size_t first = text.find_first_not_of("+-");
    if (first == std::string_view::npos) return false;
    std::string word(text.substr(first));
    for (char& c : word) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return word == "nan" || word.substr(0, 4) == "nan(" || word == "inf" || word == "infinity" || word.substr(0, 3) == "1.#";
}

std::string number_defect(std::string_view text) {
    const std::string_view number = without_plus(trimmed(text));
    if (number.empty()) return "a number is missing (the text is empty)";
    double value = 0.0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (error == std::errc::result_out_of_range) return in_quotes(text) + " is outside the range of double precision";
    if (error != std::errc()) return in_quotes(text) + " is not a number";
    if (!std::isfinite(value)) return in_quotes(text) + " is not a finite number";
    const std::string_view rest = number.substr(static_cast<std::size_t>(end - number.data()));
    if (!rest.empty() && rest[0] == ',') return in_quotes(text) + " is not a number (the decimal mark is a point)";
    return in_quotes(text) + " is not a number: unexpected " + in_quotes(rest);
}

std::string closest_name(const std::string& name, const std::vector<std::string>& candidates) {
    constexpr std::size_t longest_name = 64;  // the distance below is quadratic in it
    if (name.size() > longest_name) return {};
    std::string best;
    std::size_t best_distance = 1 + std::min<std::size_t>(name.size() / 3, 3);  // a third of the letters may differ
    for (const std::string& candidate : candidates) {
        std::vector<std::size_t> row(candidate.size() + 1);  // Levenshtein, one row at a time
        std::iota(row.begin(), row.end(), std::size_t{0});
        for (std::size_t i = 0; i < name.size(); ++i) {
            std::size_t diagonal = row[0]++;
            for (std::size_t j = 0; j < candidate.size(); ++j) {
                const std::size_t above = row[j + 1];
                row[j + 1] = std::min({above + 1, row[j] + 1, diagonal + (name[i] == candidate[j] ? 0 : 1)});
                diagonal = above;
            }
        }
        if (row.back() < best_distance) {
            best_distance = row.back();
            best = candidate;
        }
    }
    return best;
}

std::vector<double> coordinates(const std::vector<std::string_view>& words) {
    std::vector<double> numbers;
    for (const std::string_view word : words) {
        const std::optional<double> number = parse_number(word);
        if (!number) throw std::invalid_argument(number_defect(word));
        if (std::abs(*number) > 1e18) throw std::invalid_argument(in_quotes(word) + " lies beyond 1e18");
        numbers.push_back(*number);
    }
    return numbers;
}

}  // namespace pencil
