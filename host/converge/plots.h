// Curves drawn by matplotlib, a separate program: without it the numbers still exist.
#pragma once

#include <filesystem>
#include <string>

namespace pencil {

/// Writes plot.py into the folder and runs it there on points.csv and summary.json; it draws into plots/. Tries $PENCIL_PYTHON if set, else
/// python3 from the path, then /usr/bin/python3. Returns why there are no plots, or nothing.
std::string make_plots(const std::filesystem::path& folder);

}  // namespace pencil
