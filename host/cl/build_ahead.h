// Kernels that a render is sure to need, built by processes beside it. PoCL builds one after the other, at its first launch, and keeps what it
// has built in a folder that processes share: what another has put there by then is only loaded.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "cl/device.h"
#include "cl/program.h"

namespace pencil {

/// One kernel with the size of its launches: PoCL makes other code for grids of 65535 work-items and more.
struct KernelBuild {
    std::string kernel;
    std::size_t items = 1;
    Defines defines;
};

/// From now on `program build-kernels` may be started, which must call build_kernels. Before, BuildAhead does nothing.
void allow_build_ahead(const std::filesystem::path& program);

class BuildAhead {
public:
    /// Starts processes, unless `builds` were built before with this driver. Those that are needed first stand first, and kernels of one
    /// program together.
    BuildAhead(const Device& device, const std::vector<KernelBuild>& builds);
    /// Ends them.
    ~BuildAhead();
    BuildAhead(const BuildAhead&) = delete;
    BuildAhead& operator=(const BuildAhead&) = delete;

private:
    std::vector<pid_t> processes_;
};

/// The work of such a process: `list` is what BuildAhead gave it. Ends with its parent.
void build_kernels(std::istream& list);

}  // namespace pencil
