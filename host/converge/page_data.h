// What the templates page*.html.mustache are filled with: texts and numbers as the reader wants them, no HTML. Values in {{}} are escaped
// there. A name that an object lacks is looked up in the objects around it.
#pragma once

#include <kainjow/mustache.hpp>

#include "converge/report.h"

namespace pencil {

using PageData = kainjow::mustache::data;
using PageObject = kainjow::mustache::object;
using PageList = kainjow::mustache::list;

/// `text`, or false for sections that are left out without it.
inline PageData if_any(const std::string& text) { return text.empty() ? PageData(false) : PageData(text); }

/// A method's name and colour, as `{{>method}}` wants them.
PageObject method_data(const Report& report, std::size_t index);

/// Three cards: who is ahead at each of `verdict_times`, by relative error.
PageList verdict_cards(const Report& report);
/// Per metric: its title, and a row for each of `verdict_times` with the error of every method.
PageList equal_time_tables(const Report& report);
/// Per round error a row: the time of every method to it.
PageList equal_error_rows(const Report& report);
/// Per method a row: slope and floor by each metric, then bias, noise, mean ratio and time of its longest runs.
PageList fit_rows(const Report& report);
/// Per stage a row: the seconds and the share of the longest runs of every method but the path tracer.
PageList stage_rows(const Report& report);

/// At about one second and at the longest time: title and images of all methods beside the reference, with their differences in colours of
/// one scale.
struct PagePictures {
    PageList rows;
    double full_colour = 1;  // the difference, relative to the reference, that is shown in full colour
};
PagePictures pictures_of(const Report& report);

}  // namespace pencil
