// Messages to the user, on stderr so that stdout stays free for results. Coloured on a terminal only.
#pragma once

#include <string>

namespace pencil {

void log_info(const std::string& message);
void log_warning(const std::string& message);

/// Hides information; warnings stay.
void set_quiet(bool quiet);

}  // namespace pencil
