// Tables of the page, each as HTML.
#pragma once

#include <string>

#include "converge/report.h"

namespace pencil {

/// Three cards: who is ahead at each of `verdict_times`, by relative error.
std::string verdict_cards(const Report& report);
/// Errors of every method at `verdict_times`, for every metric.
std::string equal_time_tables(const Report& report);
/// Time to round errors, and the path tracer's time as a multiple of it.
std::string equal_error_table(const Report& report);
/// Slope, floor, bias and noise of every method.
std::string fit_table(const Report& report);
/// Seconds per stage of the longest budget.
std::string stage_table(const Report& report);

/// Colour of a method on the page and in plot.py.
std::string method_colour(std::size_t index);
/// The name with a dot of its colour.
std::string method_label(const Report& report, std::size_t index);

}  // namespace pencil
