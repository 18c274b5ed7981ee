// Numbers and names taken from untrusted text. Numbers are read whole, finite and independent of the locale; names are made safe to print.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pencil {

/// Control characters and bytes that are not UTF-8 as \xNN, cut after `limit` bytes: nothing from a file may steer a terminal.
std::string escaped(std::string_view text, std::size_t limit = 80);
/// escaped() between double quotes.
std::string in_quotes(std::string_view text);

bool is_utf8(std::string_view text);
/// Text in UTF-16 with its mark, or else in Latin-1 where it is not UTF-8, as UTF-8.
std::string as_utf8(std::string text);

/// True if the first bytes are the mark of UTF-16 or UTF-8.
bool has_encoding_mark(std::string_view text);
/// Text with such a mark as UTF-8 without it; other text as it is.
std::string decoded_by_mark(std::string_view text);

std::string_view trimmed(std::string_view text);
/// The first line that is neither empty nor a comment after #, trimmed.
std::string_view first_statement(std::string_view text);
/// Splits at blanks and commas, as Mitsuba does; no empty tokens.
std::vector<std::string_view> tokens(std::string_view text);

/// The whole of `text` as one finite decimal number, blanks around it allowed.
std::optional<double> parse_number(std::string_view text);
std::optional<long long> parse_integer(std::string_view text);
/// True for what programs write for NaN and infinity: nan, -nan(ind), inf, 1.#QNAN.
bool is_no_number(std::string_view text);
/// Why parse_number refused `text`, with the text in it, for messages.
std::string number_defect(std::string_view text);
/// All words as coordinates, none beyond 1e18. std::invalid_argument.
std::vector<double> coordinates(const std::vector<std::string_view>& words);

/// The candidate closest to `name`, or empty if none is close.
std::string closest_name(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace pencil
