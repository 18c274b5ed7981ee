// An OpenCL device with its context and queue: discovery, selection, planned memory, profiling. Only host/cl sees the OpenCL headers'
// settings; include cl/opencl.h, never CL/opencl.hpp.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "cl/device_profile.h"
#include "cl/faults.h"
#include "cl/opencl.h"
#include "util/launch_times.h"

namespace pencil {

struct DeviceInfo {
    int index = 0;  // the number `--device` takes
    std::string platform, name, vendor, driver, version;
    bool is_cpu = false;
    std::uint64_t global_memory = 0, max_allocation = 0, local_memory = 0;  // [bytes]
    unsigned compute_units = 0, native_float_width = 1;
    std::size_t max_work_group = 1;
};

/// All devices of all platforms, in a stable order. Never throws for "none": see `no_device_advice`.
std::vector<DeviceInfo> list_devices();
/// What was found instead of a device and the usual causes (no writable cache directory, POCL_DEVICES, OCL_ICD_VENDORS).
std::string no_device_advice();

/// Time that the device spent on a finished command [s].
double event_seconds(const cl::Event& event);

struct FoundDevice;

class Device {
public:
    /// `selector`: index, or part of the name or platform (any case), "cpu", "gpu", or empty: $PENCIL_DEVICE if
    /// set, else first GPU, else first CPU.
    /// DeviceError if nothing matches, listing what exists.
    static std::shared_ptr<Device> open(const std::string& selector);

    /// Those that `selectors` name, with commas between; UsageError if one is named twice.
    static std::vector<std::shared_ptr<Device>> open_several(const std::string& selectors);

    /// The first other device, GPUs first; null if there is none.
    static std::shared_ptr<Device> open_another(const std::set<int>& but);

    const DeviceInfo& info() const { return info_; }
    const cl::Context& context() const { return context_; }
    cl::CommandQueue& queue() { return queue_; }
    const cl::Device& cl_device() const { return device_; }

    /// How its kernels are built and launched: generic, or as tuned (cl/profile_file.h); $PENCIL_WIDTH (1, 4, 8, 16) is the generic profile
    /// with packets of that width, for tests.
    const DeviceProfile& profile() const { return profile_; }
    /// Of programs and launches from now on.
    void set_profile(const DeviceProfile& profile) { profile_ = profile; }
    /// Surfels per work-item in packet kernels (PENCIL_WIDTH).
    int packet_width() const { return profile_.packet_width; }
    /// Work-items per work-group of a kernel that asks for no number; fixed, because PoCL generates code per local size.
    std::size_t local_size(const std::string& kernel = "") const;

    /// Throws what $PENCIL_FAULT asks for at the next launch or allocation (cl/faults.h).
    void launch_may_fail() { faults_.at_launch(); }
    void allocation_may_fail() { faults_.at_allocation(); }

    /// Bookkeeping of planned allocation. `reserve` throws MemoryError, saying what for and how much is free, before anything is allocated.
    void reserve(std::uint64_t bytes, const std::string& what);
    void release(std::uint64_t bytes);
    std::uint64_t allocated() const { return allocated_; }
    std::uint64_t peak_allocated() const { return peak_; }

    /// Times by launch description, filled by Kernel::run.
    void record(const std::string& description, const std::string& kernel, const cl::Event& event);
    std::map<std::string, LaunchTimes> launch_times();  // waits for the queue
    std::map<std::string, LaunchTimes> kernel_times();  // the same by kernel
    double build_seconds() const { return build_seconds_; }
    void add_build_seconds(double s) { build_seconds_ += s; }
    void finish();

    /// Programs of this device by options and source: renders one after the other build each but once.
    std::map<std::string, cl::Program>& programs() { return programs_; }

    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

private:
    Device(cl::Device device, DeviceInfo info);
    static std::shared_ptr<Device> open_found(const FoundDevice& found);
    void drain(bool wait);
    cl::Device device_;
    DeviceInfo info_;
    cl::Context context_;
    cl::CommandQueue queue_;
    DeviceProfile profile_;
    std::uint64_t allocated_ = 0, peak_ = 0;
    double build_seconds_ = 0;
    std::map<std::string, cl::Program> programs_;
    Faults faults_;
    struct Pending {
        std::string description, kernel;
        cl::Event event;
    };
    std::vector<Pending> pending_;
    std::map<std::string, LaunchTimes> times_, kernel_times_;
};

}  // namespace pencil
