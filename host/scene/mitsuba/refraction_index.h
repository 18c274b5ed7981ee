// Indices of refraction by the names that Mitsuba gives them.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pencil {

std::optional<double> refraction_index(const std::string& name);
std::vector<std::string> refraction_names();

}  // namespace pencil
