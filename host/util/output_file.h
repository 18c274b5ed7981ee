// Results reach their final name whole or not at all: written beside it under a temporary name, then renamed. An older result with
// that name stays as it was until then.
#pragma once

#include <cstddef>
#include <filesystem>

namespace pencil {

/// Tries what `write_file` will need, before hours of work depend on it. OutputError unless a file can be created in the folder of
/// `path`, and `path` is absent or a regular file.
void check_writable(const std::filesystem::path& path);

/// Replaces `path` (the target, if it is a symbolic link) by `bytes` of `data`. OutputError if that fails; nothing is left behind then.
void write_file(const std::filesystem::path& path, const void* data, std::size_t bytes);

/// The same of a file that none but its owner may read or write, whatever the umask.
void write_private_file(const std::filesystem::path& path, const void* data, std::size_t bytes);

}  // namespace pencil
