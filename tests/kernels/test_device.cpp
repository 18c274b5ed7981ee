// Devices: discovery, selection, what is said when there is none, the memory plan and the launch times.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>

#include "cl/discovery.h"
#include "cl/program.h"
#include "cl/self_test.h"
#include "kernels/child_process.h"
#include "util/error.h"

namespace pencil {
namespace {

constexpr const char* test_kernels = PENCIL_SOURCE_DIR "/tests/kernels/test_program.cl";

template <typename E>
std::string message_of(const std::function<void()>& f) {
    try {
        f();
    } catch (const E& error) {
        return error.what();
    }
    return "nothing was thrown";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::vector<DeviceInfo> three_devices() {
    std::vector<DeviceInfo> devices(3);
    for (int i = 0; i < 3; ++i) devices[i].index = i;
    devices[0].name = "pthread-EPYC";
    devices[0].platform = "Portable Computing Language";
    devices[0].is_cpu = true;
    devices[1].name = "Big GPU 1000";
    devices[1].platform = "Vendor A";
    devices[2].name = "Big GPU 2000";
    devices[2].platform = "Vendor B";
    return devices;
}

// Tests that take away PoCL's devices say nothing where another driver has some.
bool only_pocl() {
    for (const DeviceInfo& device : list_devices())
        if (device.platform != "Portable Computing Language") return false;
    return true;
}

TEST(Device, ListsDevicesWithConsecutiveIndicesAndSaneProperties) {
    const std::vector<DeviceInfo> devices = list_devices();
    ASSERT_FALSE(devices.empty()) << no_device_advice();
    for (std::size_t i = 0; i < devices.size(); ++i) {
        EXPECT_EQ(devices[i].index, static_cast<int>(i));
        EXPECT_FALSE(devices[i].name.empty());
        EXPECT_GT(devices[i].compute_units, 0u);
        EXPECT_GT(devices[i].max_work_group, 0u);
        EXPECT_GT(devices[i].max_allocation, 0u);
        EXPECT_LE(devices[i].max_allocation, devices[i].global_memory);
    }
}

TEST(Device, SelectorMeansIndexNamePlatformOrKind) {
    const std::vector<DeviceInfo> devices = three_devices();
    EXPECT_EQ(select_device(devices, "2"), 2u);
    EXPECT_EQ(select_device(devices, "gpu 2000"), 2u);
    EXPECT_EQ(select_device(devices, "PORTABLE"), 0u);
    EXPECT_EQ(select_device(devices, "cpu"), 0u);
    EXPECT_EQ(select_device(devices, "gpu"), 1u);
    EXPECT_EQ(select_device(devices, ""), 1u);
    EXPECT_EQ(select_device({devices[0]}, ""), 0u);
}

TEST(Device, WrongSelectorListsWhatExists) {
    for (const std::string selector : {"3", "no such device", "-1", "2000 GPU", "99999999999999999999"}) {
        const std::string message = message_of<DeviceError>([&] { select_device(three_devices(), selector); });
        EXPECT_TRUE(contains(message, "\"" + selector + "\"")) << message;
        EXPECT_TRUE(contains(message, "1  Big GPU 1000 (Vendor A, gpu)")) << message;
    }
    EXPECT_TRUE(contains(message_of<DeviceError>([] { Device::open("no such device"); }), "no OpenCL device matches"));
}

TEST(Device, PacketWidthIsAllowedAndOverridable) {
    const auto device = Device::open("");
    const int width = device->packet_width();
    EXPECT_TRUE(width == 1 || width == 4 || width == 8 || width == 16) << width;
    EXPECT_GE(device->local_size(), 1u);
    EXPECT_LE(device->local_size(), device->info().max_work_group);
    setenv("PENCIL_WIDTH", "4", 1);
    EXPECT_EQ(Device::open("")->packet_width(), 4);
    setenv("PENCIL_WIDTH", "5", 1);
    EXPECT_TRUE(contains(message_of<UsageError>([] { Device::open(""); }), "PENCIL_WIDTH=5"));
    unsetenv("PENCIL_WIDTH");
}

TEST(Device, MemoryPlanRefusesBeforeAllocating) {
    const auto device = Device::open("");
    const std::uint64_t largest = device->info().max_allocation, global = device->info().global_memory;
    const std::string single = message_of<MemoryError>([&] { device->reserve(largest + 1, "pencil maps"); });
    EXPECT_TRUE(contains(single, "pencil maps needs one buffer of")) << single;
    EXPECT_TRUE(contains(single, "fewer pencils")) << single;
    EXPECT_EQ(device->allocated(), 0u);

    std::uint64_t taken = 0;
    while (taken + largest <= global / 10 * 9) {
        device->reserve(largest, "filler");
        taken += largest;
    }
    EXPECT_EQ(device->allocated(), taken);
    const std::string total = message_of<MemoryError>([&] { device->reserve(largest, "film layers"); });
    EXPECT_TRUE(contains(total, "film layers needs")) << total;
    EXPECT_TRUE(contains(total, "are in use")) << total;
    EXPECT_EQ(device->allocated(), taken);
    device->release(taken);
    EXPECT_EQ(device->allocated(), 0u);
    EXPECT_EQ(device->peak_allocated(), taken);
}

TEST(Device, LaunchTimesCountEveryLaunch) {
    const auto device = Device::open("");
    ProgramCache programs(device);
    Buffer<int> counts(device, 100, "counts");
    counts.fill_zero();
    for (int i = 0; i < 1000; ++i)
        programs.kernel("count_visits", test_kernels).args(counts, 100).run(100, i % 4 == 0 ? "fourth" : "other");
    const auto times = device->launch_times();
    ASSERT_EQ(times.size(), 2u);
    EXPECT_EQ(times.at("fourth").launches, 250);
    EXPECT_EQ(times.at("other").launches, 750);
    EXPECT_GT(times.at("other").device_seconds, 0.0);
    EXPECT_EQ(counts.read(), std::vector<int>(100, 1000));
    EXPECT_EQ(device->launch_times().at("other").launches, 750) << "asking twice must not count twice";
}

// The children's part: opens the default device and runs the self-test; prints the error and returns its exit code otherwise.
TEST(DISABLED_Child, OpensDeviceAndTestsIt) {
    try {
        for (const DeviceInfo& info : list_devices()) std::printf("device %d %s\n", info.index, info.name.c_str());
        ProgramCache programs(Device::open(""));
        for (const SelfTestResult& result : self_test(programs)) EXPECT_TRUE(result.passed) << result.name << ": " << result.detail;
        std::printf("opened %d\n", programs.device()->info().index);
    } catch (const Error& error) {
        std::printf("%s\n", error.what());
        std::fflush(stdout);
        std::_Exit(static_cast<int>(error.code()));
    }
}

ChildResult open_in_child(const std::string& environment, const std::string& wrapper = "") {
    return run_child_test("DISABLED_Child.OpensDeviceAndTestsIt", environment, wrapper);
}

TEST(DeviceInChild, NoPlatformNamesTheLoaderVariable) {
    const ChildResult child = open_in_child("OCL_ICD_VENDORS=/empty");
    EXPECT_EQ(child.status, static_cast<int>(ExitCode::device)) << child.output;
    EXPECT_TRUE(contains(child.output, "OCL_ICD_VENDORS=/empty")) << child.output;
    EXPECT_TRUE(contains(child.output, "pocl-opencl-icd")) << child.output;
}

TEST(DeviceInChild, PlatformWithoutDeviceNamesPoclVariables) {
    if (!only_pocl()) GTEST_SKIP() << "another platform has devices";
    const ChildResult unknown = open_in_child("POCL_DEVICES=bogus");
    EXPECT_EQ(unknown.status, static_cast<int>(ExitCode::device)) << unknown.output;
    EXPECT_TRUE(contains(unknown.output, "Portable Computing Language")) << unknown.output;
    EXPECT_TRUE(contains(unknown.output, "POCL_DEVICES=bogus")) << unknown.output;
    const ChildResult cache = open_in_child("POCL_CACHE_DIR=/proc/nowhere");
    EXPECT_EQ(cache.status, static_cast<int>(ExitCode::device)) << cache.output;
    EXPECT_TRUE(contains(cache.output, "POCL_CACHE_DIR=/proc/nowhere")) << cache.output;
}

TEST(DeviceInChild, BrokenDriversDoNotHideOthers) {
    const std::filesystem::path vendors = std::filesystem::path(testing::TempDir()) / ("pencil_vendors_" + std::to_string(getpid()));
    std::filesystem::create_directories(vendors);
    std::error_code error;
    for (const auto& driver : std::filesystem::directory_iterator("/etc/OpenCL/vendors", error))
        std::filesystem::copy(driver.path(), vendors / driver.path().filename());
    std::ofstream(vendors / "aaa_broken.icd") << "libno_such_driver.so\n";
    const ChildResult child = open_in_child("OCL_ICD_VENDORS=" + vendors.string());
    EXPECT_EQ(child.status, 0) << child.output;
    std::filesystem::remove_all(vendors);
}

TEST(DeviceInChild, UnwritableHomeIsWorkedAround) {
    const std::filesystem::path temporary = std::filesystem::path(testing::TempDir()) / ("pencil_home_" + std::to_string(getpid()));
    std::filesystem::create_directories(temporary);
    const std::string nowhere = "HOME=/proc/nowhere TMPDIR=" + temporary.string();
    const ChildResult unset = open_in_child("-u XDG_CACHE_HOME -u POCL_CACHE_DIR " + nowhere);
    EXPECT_EQ(unset.status, 0) << unset.output;
    EXPECT_TRUE(contains(unset.output, "using POCL_CACHE_DIR=" + temporary.string())) << unset.output;
    const ChildResult empty = open_in_child("-u XDG_CACHE_HOME POCL_CACHE_DIR= " + nowhere);
    EXPECT_EQ(empty.status, 0) << empty.output;
    std::filesystem::remove_all(temporary);
}

TEST(DeviceInChild, SelfTestPassesOnPoclVariants) {
    if (!only_pocl() || list_devices().at(0).driver.rfind("3.", 0) != 0) GTEST_SKIP() << "device names of PoCL 3";
    for (const std::string environment : {"POCL_DEVICES=basic", "POCL_MAX_PTHREAD_COUNT=1", "POCL_MAX_WORK_GROUP_SIZE=16",
                                          "POCL_WORK_GROUP_METHOD=loops", "POCL_MEMORY_LIMIT=1", "PENCIL_WIDTH=1", "PENCIL_WIDTH=16"}) {
        const ChildResult child = open_in_child(environment);
        EXPECT_EQ(child.status, 0) << environment << "\n" << child.output;
    }
    const ChildResult second = open_in_child("PENCIL_DEVICE=1 POCL_DEVICES='pthread pthread'");
    EXPECT_EQ(second.status, 0) << second.output;
    EXPECT_TRUE(contains(second.output, "device 1 ")) << second.output;
    EXPECT_TRUE(contains(second.output, "opened 1")) << second.output;
}

TEST(DeviceInChild, OclgrindFindsNothingInTheSelfTest) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the address sanitizer must be loaded first, and so must oclgrind";
#endif
    if (std::system("command -v oclgrind >/dev/null 2>&1") != 0) GTEST_SKIP() << "oclgrind is not installed";
    const ChildResult child = open_in_child("", "oclgrind --data-races --check-api");
    EXPECT_EQ(child.status, 0) << child.output;
    EXPECT_TRUE(contains(child.output, "Oclgrind Simulator")) << child.output;
    for (const char* complaint : {"Invalid read", "Invalid write", "data race", "divergence", "Oclgrind - OpenCL runtime error"})
        EXPECT_FALSE(contains(child.output, complaint)) << child.output;
}

}  // namespace
}  // namespace pencil
