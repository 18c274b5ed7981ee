// Options in the files that a run leaves behind: --stats and image headers.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "image/write_image.h"
#include "options/option.h"

namespace pencil {

/// Keys by option_key, values as shown; null for options that are not given.
nlohmann::ordered_json options_json(const std::vector<Option>& table);

/// Values under "pencil:" and header_name; options that are not given are left out, seeds and lists are text.
void add_options(Metadata& metadata, const std::vector<Option>& table);

}  // namespace pencil
