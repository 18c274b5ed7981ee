// Devices of all platforms with their OpenCL handles, and the choice of one. The public face without handles is cl/device.h.
#pragma once

#include <string>
#include <vector>

#include "cl/device.h"

namespace pencil {

struct FoundDevice {
    cl::Device handle;
    DeviceInfo info;
};

/// Usable devices: available, with a compiler, OpenCL 1.2 or later. Others are skipped with a warning.
std::vector<FoundDevice> find_devices();

/// Index into `found` of the device that `selector` means (see Device::open); DeviceError if none.
std::size_t select_device(const std::vector<DeviceInfo>& found, const std::string& selector);

}  // namespace pencil
