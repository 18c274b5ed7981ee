// The table of the options of a render: every name, range, default and help text.
#pragma once

#include "options/option.h"
#include "options/render_options.h"

namespace pencil {

/// One row per option, bound to the fields of `options`, which must outlive the rows.
std::vector<Option> render_option_table(RenderOptions& options);

/// --lumens-per-watt.
Option lumens_row(double& lumens_per_watt);

/// A value as the command line would spell it.
std::string spelled(const OptionValue& value);

/// UsageError if a value is none that its row accepts: for options that no command line has read.
void check_options(RenderOptions options);

/// Words of the command line.
/// --map, the width of octahedral maps.
Option map_option(int& map);
std::string to_string(MethodName method);

}  // namespace pencil
