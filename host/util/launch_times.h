// Accumulated time of the kernel launches that share a description.
#pragma once

namespace pencil {

struct LaunchTimes {
    int launches = 0;
    double device_seconds = 0;
};

}  // namespace pencil
