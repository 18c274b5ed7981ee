// `pencil devices`: what `--device` can choose from, and whether it can be trusted.
#include <iostream>

#include "app/commands.h"
#include "app/message.h"
#include "util/format.h"
#include "cl/self_test.h"

namespace pencil {
namespace {

void print_device(const DeviceInfo& device) {
    std::cout << device.index << "  " << printable(device.name) << "\n"
              << "   platform  " << printable(device.platform) << "\n"
              << "   driver    " << printable(device.driver) << ", " << printable(device.version) << "\n"
              << "   kind      " << (device.is_cpu ? "CPU" : "GPU or accelerator") << ", " << device.compute_units << " compute units, "
              << device.native_float_width << " floats wide\n"
              << "   memory    " << format_size(device.global_memory) << ", " << format_size(device.max_allocation) << " in one piece, "
              << format_size(device.local_memory) << " local\n";
}

/// True if every check passed.
bool test_device(const DeviceInfo& info) {
    ProgramCache programs(Device::open(std::to_string(info.index)));
    bool passed = true;
    for (const SelfTestResult& result : self_test(programs)) {
        std::cout << "   " << (result.passed ? "passed" : "FAILED") << "    " << printable(result.name)
                  << (result.detail.empty() ? "" : ": ") << printable(result.detail) << "\n";
        passed = passed && result.passed;
    }
    return passed;
}

}  // namespace

ExitCode run_devices(const DevicesCommand& command) {
    const std::vector<DeviceInfo> devices = list_devices();
    if (devices.empty()) {
        throw DeviceError(no_device_advice());
    }
    bool passed = true;
    for (const DeviceInfo& device : devices) {
        print_device(device);
        std::cout.flush();
        if (command.self_test) {
            passed = test_device(device) && passed;
        }
    }
    if (!passed) {
        throw DeviceError("a device gave wrong answers; do not trust its images");
    }
    return ExitCode::ok;
}

}  // namespace pencil
