// Which kernels are built together. A program costs about 15 ms to set up even when the driver has it in its cache (measured on PoCL 3.1),
// so kernels that a render needs together share one; a render that does not need a group never builds it.
#pragma once

#include <string>
#include <vector>

namespace pencil {

struct KernelGroup {
    std::vector<std::string> libraries;  // kernels/lib/<name>.cl, in order
    std::vector<std::string> kernels;    // kernels/<name>.cl
};

/// The group that holds a kernel, null if none does.
const KernelGroup* find_group(const std::string& kernel);

}  // namespace pencil
