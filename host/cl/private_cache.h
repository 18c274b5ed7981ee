// Folders of the user's cache whose files decide what the program does: they must be the user's alone.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pencil {

/// $XDG_CACHE_HOME/pencil/`name`, else $HOME/.cache/pencil/`name`; with `make` made if absent. Empty if there is none, or others may write it.
std::filesystem::path private_cache(const std::string& name, bool make);

/// Of a file that only this user may write, at most `most` bytes long; else nothing.
std::vector<char> read_private(const std::filesystem::path& file, std::size_t most);

}  // namespace pencil
