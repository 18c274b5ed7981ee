// What is measured: named ways of rendering, each a ladder of growing budgets. A new method is a new entry of the table in methods.cpp.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "options/render_options.h"

namespace pencil {

struct Budget {
    RenderOptions options;  // but for size, bounces and seed
    std::string flags;      // the same, as options of `pencil render`
};

struct MeasuredMethod {
    std::string name;
    std::string summary;  // one sentence for readers of the page
    std::function<Budget(int step)> budget;
};

/// The methods of `pencil render`, in the order of the page.
const std::vector<MeasuredMethod>& all_methods();
/// Their names.
std::vector<std::string> method_names();
/// By name, which must be one of all_methods().
const MeasuredMethod& find_method(const std::string& name);

/// The baseline that every run includes: the reference path tracer with budgets of time.
extern const char* const path_tracer_name;
extern const char* const path_tracer_summary;
/// [s]
double path_tracer_seconds(int step);

}  // namespace pencil
