// What a device that helps the first one has: kernels and the scene in its own memory.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "device/device_scene.h"
#include "device/features.h"

namespace pencil {

struct DeviceCopy {
    Kernels kernels;
    DeviceScene scene;
    std::string failure;  // why it helps no more; empty: it does
};

/// What became of devices that help, where several share a render: it is said of the whole of it, whatever pass is begun anew.
struct HelperReport {
    std::vector<std::string> notes;                // which help no more, and why
    std::map<std::string, std::uint64_t> pencils;  // that each device gathered; empty where the first was alone from the start
};

}  // namespace pencil
