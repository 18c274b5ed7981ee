// PoCL needs a writable cache directory: without one it shows its platform with no device and says nothing.
#pragma once

#include <filesystem>

namespace pencil {

/// Call before the first OpenCL call. Where PoCL's own cache directory cannot be made and the user chose none, points it to a private
/// directory below the temporary directory. Does nothing the second time. Must not race with getenv in other threads.
void prepare_pocl_cache();

/// The folder that PoCL keeps its cache in, once it has been prepared.
std::filesystem::path pocl_cache();

/// Name of its platform.
constexpr const char* pocl_platform = "Portable Computing Language";

}  // namespace pencil
