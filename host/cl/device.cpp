// One device: context, profiling queue, the memory plan and the times of its launches.
#include "cl/device.h"

#include <algorithm>
#include <sstream>

#include "cl/cl_error.h"
#include "cl/discovery.h"
#include "cl/profile_file.h"
#include "util/environment.h"
#include "util/error.h"
#include "util/log.h"

namespace pencil {
namespace {

// Drivers keep some memory for themselves, and fail late and badly when it is gone.
constexpr double usable_memory = 0.9;
// An event holds driver memory: finished ones are read and dropped whenever this many are kept.
constexpr std::size_t events_kept = 256;

int width_from_environment() {
    const std::string text = environment("PENCIL_WIDTH");
    if (text.empty()) return 0;
    for (int width : {1, 4, 8, 16})
        if (text == std::to_string(width)) return width;
    throw UsageError("PENCIL_WIDTH=" + text + " is not 1, 4, 8 or 16");
}

/// What was measured for the device, where that may be used.
DeviceProfile profile_of(const DeviceInfo& info) {
    DeviceProfile profile = generic_profile(info);
    if (const int width = width_from_environment(); width != 0) {
        profile.packet_width = width;
        profile.block = generic_block(width);
        return profile;
    }
    if (!tuned_profiles_allowed()) return profile;
    const ReadProfile read = read_profile(info);
    if (!read.trouble.empty()) log_warning(read.trouble);
    return read.profile.value_or(profile);
}

}  // namespace

double event_seconds(const cl::Event& event) {
    const auto start = event.getProfilingInfo<CL_PROFILING_COMMAND_START>();
    const auto end = event.getProfilingInfo<CL_PROFILING_COMMAND_END>();
    return end > start ? static_cast<double>(end - start) * 1e-9 : 0.0;
}

std::shared_ptr<Device> Device::open(const std::string& selector) {
    std::vector<FoundDevice> found = find_devices();
    std::vector<DeviceInfo> infos;
    infos.reserve(found.size());
    for (const FoundDevice& device : found) infos.push_back(device.info);
    const std::string usual = environment("PENCIL_DEVICE");  // the first, if there are several
    return open_found(found[select_device(infos, selector.empty() ? usual.substr(0, usual.find(',')) : selector)]);
}

std::vector<std::shared_ptr<Device>> Device::open_several(const std::string& selectors) {
    std::vector<std::shared_ptr<Device>> devices;
    std::istringstream each(selectors.empty() ? environment("PENCIL_DEVICE") : selectors);
    for (std::string one; std::getline(each, one, ',');) {
        if (one.empty()) throw UsageError("--device " + selectors + ": an empty name between commas");
        const std::shared_ptr<Device> device = open(one);
        for (const std::shared_ptr<Device>& other : devices)
            if (other->info().index == device->info().index)
                throw UsageError("--device " + selectors + ": " + device->info().name + " is named twice");
        devices.push_back(device);
    }
    if (devices.empty()) devices.push_back(open(""));
    return devices;
}

std::shared_ptr<Device> Device::open_another(const std::set<int>& but) {
    std::vector<FoundDevice> found = find_devices();
    std::stable_partition(found.begin(), found.end(), [](const FoundDevice& device) { return !device.info.is_cpu; });
    for (const FoundDevice& device : found)
        if (but.count(device.info.index) == 0) return open_found(device);
    return nullptr;
}

std::shared_ptr<Device> Device::open_found(const FoundDevice& found) {
    return cl_call([&] { return "opening OpenCL device " + found.info.name; },
                   [&] { return std::shared_ptr<Device>(new Device(found.handle, found.info)); });
}

Device::Device(cl::Device device, DeviceInfo info)
    : device_(std::move(device)),
      info_(std::move(info)),
      context_(device_),
      queue_(context_, device_, CL_QUEUE_PROFILING_ENABLE),
      profile_(profile_of(info_)) {}

// Waits, because buffers that commands still use must not die under them; a failed device cannot be waited for.
Device::~Device() {
    try {
        queue_.finish();
    } catch (const cl::Error&) {
    }
}

std::size_t Device::local_size(const std::string& kernel) const { return std::min(profile_.group_of(kernel), info_.max_work_group); }

void Device::reserve(std::uint64_t bytes, const std::string& what) {
    const auto usable = static_cast<std::uint64_t>(usable_memory * static_cast<double>(info_.global_memory));
    const std::string advice = " Try fewer pencils, a smaller map or resolution, or another device.";
    if (bytes > info_.max_allocation) {
        throw MemoryError(what + " needs one buffer of " + format_bytes(bytes) + ", and " + info_.name + " allows at most " +
                          format_bytes(info_.max_allocation) + " per buffer." + advice);
    }
    const std::uint64_t unused = usable > allocated_ ? usable - allocated_ : 0;
    if (bytes > unused) {
        throw MemoryError(what + " needs " + format_bytes(bytes) + ", and of the " + format_bytes(usable) + " usable on " + info_.name +
                          " " + format_bytes(allocated_) + " are in use: " + format_bytes(unused) + " left." + advice);
    }
    allocated_ += bytes;
    peak_ = std::max(peak_, allocated_);
}

void Device::release(std::uint64_t bytes) { allocated_ -= std::min(bytes, allocated_); }

void Device::record(const std::string& description, const std::string& kernel, const cl::Event& event) {
    pending_.push_back({description, kernel, event});
    if (pending_.size() >= events_kept) drain(false);
}

// The queue runs in order, so everything before the first unfinished event is finished.
void Device::drain(bool wait) {
    if (pending_.empty()) return;
    if (wait) finish();
    std::size_t done = 0;
    for (; done < pending_.size(); ++done) {
        const auto& [description, kernel, event] = pending_[done];
        const int status = cl_call([&, &text = description] { return "asking about \"" + text + "\" on " + info_.name; },
                                   [&, &e = event] { return e.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>(); });
        if (status > CL_COMPLETE) break;
        if (status < 0) {
            const std::string failed = description;
            pending_.clear();
            throw_cl_error(cl::Error(status, "execution"), "running \"" + failed + "\" on " + info_.name);
        }
        for (LaunchTimes* times : {&times_[description], &kernel_times_[kernel]}) {
            ++times->launches;
            times->device_seconds += event_seconds(event);
        }
    }
    pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(done));
    // A queue that runs far ahead of the device holds memory for each command: let it catch up.
    if (done == 0 && pending_.size() >= 16 * events_kept) drain(true);
}

std::map<std::string, LaunchTimes> Device::launch_times() {
    drain(true);
    return times_;
}

std::map<std::string, LaunchTimes> Device::kernel_times() {
    drain(true);
    return kernel_times_;
}

void Device::finish() {
    cl_call([&] { return "waiting for " + info_.name; }, [&] { queue_.finish(); });
}

}  // namespace pencil
