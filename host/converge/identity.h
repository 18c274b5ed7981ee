// What all runs of a folder must share to be compared with each other, kept in the folder as run.json.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "converge/points.h"

namespace pencil {

using Identity = std::map<std::string, std::string>;

/// UsageError naming the difference if the folder was filled with another value of one of these, if `points` exist without run.json, or if
/// a point's options are not those of its method and budget today.
void check_identity(const std::filesystem::path& folder, const Identity& identity, const std::vector<RunPoint>& points);

void write_identity(const std::filesystem::path& folder, const Identity& identity);

}  // namespace pencil
