// Texts of kernels: embedded at build time or read from disk, with `#include "..."` resolved, so that every file names what it uses.
#pragma once

#include <string>
#include <vector>

namespace pencil {

/// Text of a file below kernels/, for example "lib/octahedral.cl"; read from $PENCIL_KERNEL_DIR if that is set. An absolute path is read
/// from disk, which serves kernels that only tests use. DeviceError if there is none.
std::string kernel_source(const std::string& file);

/// The whole program that `text` begins: lines #include "lib/x.cl" are replaced by that file, each file once, depth first; a text on disk
/// includes what lies beside it, too; a star in a name stands for all files that fit. #line directives
/// keep the names and lines of files in the compiler's messages; `file` stands for the text in them. DeviceError naming file and line for
/// includes that cannot be found, and for a file first included between #if and #endif that includes others: a false branch would hide them.
std::string resolve_includes(const std::string& text, const std::string& file);

/// resolve_includes of a file.
std::string program_source(const std::string& file);

/// The file of kernels/programs that includes `kernel`.cl, or `kernel`.cl itself if none does. Kernels that one render needs together share
/// a program: building one costs about 25 ms on PoCL even when it is cached.
std::string program_of(const std::string& kernel);

/// Files of all programs that are built in: those of kernels/programs, and kernels that are a program of their own.
std::vector<std::string> program_files();

}  // namespace pencil
