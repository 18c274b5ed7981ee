// OpenCL status codes as readable errors: what was being done, on what, the code's name and what usually helps.
#pragma once

#include <string>
#include <utility>

#include "cl/opencl.h"

namespace pencil {

/// "CL_OUT_OF_RESOURCES" for -5; "unknown code" otherwise.
const char* cl_error_name(int code);

/// Throws MemoryError for the codes that mean memory, DeviceError otherwise. `doing`: "launching transport (on GPU X)".
[[noreturn]] void throw_cl_error(const cl::Error& error, const std::string& doing);

/// Calls `f` and translates what it throws. `doing` is a function that returns the text, so that it costs nothing when all is well.
template <typename Doing, typename F>
auto cl_call(Doing&& doing, F&& f) -> decltype(f()) {
    try {
        return std::forward<F>(f)();
    } catch (const cl::Error& error) {
        throw_cl_error(error, doing());
    }
}

/// "12.5 MiB", or bytes below one KiB.
std::string format_bytes(std::uint64_t bytes);

}  // namespace pencil
