// Programs as the driver made them, in files: for drivers that keep none of their own and build for seconds at each start.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cl/device.h"

namespace pencil {

class ProgramBinaries {
public:
    using Binary = std::vector<unsigned char>;

    /// In $XDG_CACHE_HOME/pencil/programs, else $HOME/.cache/pencil/programs. Nothing is kept for drivers that do it themselves (PoCL,
    /// NVIDIA), where the folder cannot be made or belongs to others, or with PENCIL_PROGRAM_CACHE=0.
    explicit ProgramBinaries(const DeviceInfo& device);

    /// What was kept of the program with this source and these build options on this device and driver. Empty if nothing, or not as it was written.
    Binary find(const std::string& options, const std::string& source) const;
    /// Files beyond the 200 used last are removed. Nothing happens if it cannot be written.
    void keep(const std::string& options, const std::string& source, const Binary& binary) const;
    bool is_on() const { return !folder_.empty(); }

private:
    std::string identity(const std::string& options, const std::string& source) const;
    std::filesystem::path file(const std::string& identity) const;
    std::string device_;
    std::filesystem::path folder_;
};

}  // namespace pencil
