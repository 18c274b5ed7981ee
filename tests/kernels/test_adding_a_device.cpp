// The example of docs/adding_a_device.md: every device that is found is opened, tested and computes.
#include <gtest/gtest.h>

#include "cl/program.h"
#include "cl/self_test.h"

namespace {

using namespace pencil;

constexpr const char* test_kernels = PENCIL_SOURCE_DIR "/tests/kernels/test_program.cl";

TEST(AddingADevice, EveryDeviceIsFoundTestedAndComputes) {
    const std::vector<DeviceInfo> devices = list_devices();
    ASSERT_FALSE(devices.empty()) << no_device_advice();
    for (const DeviceInfo& info : devices) {
        const std::shared_ptr<Device> device = Device::open(std::to_string(info.index));
        EXPECT_EQ(device->info().name, info.name);

        ProgramCache programs(device);
        for (const SelfTestResult& result : self_test(programs))
            EXPECT_TRUE(result.passed) << info.name << ", " << result.name << ": " << result.detail;

        Buffer<float> values(device, std::vector<float>{1.0F, 2.0F, 3.0F}, "values");
        programs.kernel("scale", test_kernels).args(values, 3, 2.0F).run(3, "scaling");
        EXPECT_EQ(values.read(), (std::vector<float>{2.0F, 4.0F, 6.0F})) << info.name;
    }
}

}  // namespace
