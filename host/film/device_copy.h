// What a device that helps the first one has: kernels and the scene in its own memory.
#pragma once

#include <string>

#include "device/device_scene.h"
#include "device/features.h"

namespace pencil {

struct DeviceCopy {
    Kernels kernels;
    DeviceScene scene;
    std::string failure;  // why it helps no more; empty: it does
};

}  // namespace pencil
