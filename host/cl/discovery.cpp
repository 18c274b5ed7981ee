// Discovery over all platforms and the choice of a device. A platform that fails is skipped, so that one broken driver does not hide the
// others.
#include "cl/discovery.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <set>

#include "cl/cl_error.h"
#include "cl/pocl_cache.h"
#include "util/error.h"
#include "util/log.h"

namespace pencil {
namespace {

std::string trimmed(const std::string& text) {
    const auto visible = [](unsigned char c) { return c != '\0' && !std::isspace(c); };
    const auto first = std::find_if(text.begin(), text.end(), visible);
    const auto last = std::find_if(text.rbegin(), text.rend(), visible).base();
    return first < last ? std::string(first, last) : "";
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

// Discovery may run several times in one process; the user reads each complaint once.
void warn_once(const std::string& message) {
    static std::mutex mutex;
    static std::set<std::string> said;
    const std::lock_guard<std::mutex> lock(mutex);
    if (said.insert(message).second) log_warning(message);
}

struct NamedPlatform {
    cl::Platform handle;
    std::string name;
};

// Sorted by name: the loader's order follows its directory listing, and indices must not change from run to run.
std::vector<NamedPlatform> find_platforms() {
    prepare_pocl_cache();
    std::vector<cl::Platform> handles;
    try {
        cl::Platform::get(&handles);
    } catch (const cl::Error&) {
        return {};  // -1001: the loader knows no platform
    }
    std::vector<NamedPlatform> platforms;
    for (const cl::Platform& handle : handles) {
        try {
            platforms.push_back({handle, trimmed(handle.getInfo<CL_PLATFORM_NAME>())});
        } catch (const cl::Error& error) {
            warn_once(std::string("an OpenCL platform is skipped: its name cannot be read: ") + cl_error_name(error.err()));
        }
    }
    std::stable_sort(platforms.begin(), platforms.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return platforms;
}

std::vector<cl::Device> devices_of(const NamedPlatform& platform) {
    std::vector<cl::Device> handles;
    try {
        platform.handle.getDevices(CL_DEVICE_TYPE_ALL, &handles);
    } catch (const cl::Error& error) {
        if (error.err() != CL_DEVICE_NOT_FOUND)
            warn_once("OpenCL platform " + platform.name + " is skipped: listing its devices failed: " + cl_error_name(error.err()));
    }
    return handles;
}

DeviceInfo read_info(const cl::Device& device, const std::string& platform) {
    DeviceInfo info;
    info.platform = platform;
    info.name = trimmed(device.getInfo<CL_DEVICE_NAME>());
    info.vendor = trimmed(device.getInfo<CL_DEVICE_VENDOR>());
    info.driver = trimmed(device.getInfo<CL_DRIVER_VERSION>());
    info.version = trimmed(device.getInfo<CL_DEVICE_VERSION>());
    info.is_cpu = (device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU) != 0;
    info.global_memory = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
    info.max_allocation = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
    info.local_memory = device.getInfo<CL_DEVICE_LOCAL_MEM_SIZE>();
    info.compute_units = device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
    info.native_float_width = device.getInfo<CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT>();
    info.max_work_group = device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>();
    return info;
}

// Empty if the device can be used.
std::string why_unusable(const cl::Device& device, const DeviceInfo& info) {
    if (!device.getInfo<CL_DEVICE_AVAILABLE>()) return "it is not available";
    if (!device.getInfo<CL_DEVICE_COMPILER_AVAILABLE>()) return "it has no compiler";
    int major = 0, minor = 0;
    if (std::sscanf(info.version.c_str(), "OpenCL %d.%d", &major, &minor) == 2 && (major < 1 || (major == 1 && minor < 2)))
        return "it offers " + info.version + ", and 1.2 is needed";
    return "";
}

std::string list_text(const std::vector<DeviceInfo>& devices) {
    std::string text;
    for (const DeviceInfo& device : devices)
        text += "\n  " + std::to_string(device.index) + "  " + device.name + " (" + device.platform + ", " +
                (device.is_cpu ? "cpu" : "gpu") + ")";
    return text;
}

}  // namespace

std::vector<FoundDevice> find_devices() {
    std::vector<FoundDevice> found;
    for (const NamedPlatform& platform : find_platforms()) {
        for (const cl::Device& handle : devices_of(platform)) {
            try {
                DeviceInfo info = read_info(handle, platform.name);
                const std::string trouble = why_unusable(handle, info);
                if (!trouble.empty()) {
                    warn_once("OpenCL device " + info.name + " is skipped: " + trouble);
                    continue;
                }
                info.index = static_cast<int>(found.size());
                found.push_back({handle, info});
            } catch (const cl::Error& error) {
                warn_once("an OpenCL device of " + platform.name +
                          " is skipped: reading its properties failed: " + cl_error_name(error.err()));
            }
        }
    }
    return found;
}

std::vector<DeviceInfo> list_devices() {
    std::vector<DeviceInfo> infos;
    for (const FoundDevice& device : find_devices()) infos.push_back(device.info);
    return infos;
}

std::string no_device_advice() {
    const auto value = [](const char* name) {
        const char* set = std::getenv(name);
        return set ? std::string(name) + "=" + set : std::string(name) + " is not set";
    };
    const std::vector<NamedPlatform> platforms = find_platforms();
    if (platforms.empty()) {
        return "The OpenCL loader found no platform. Usual causes: no driver is installed (a CPU driver: package pocl-opencl-icd; a GPU: "
               "its "
               "vendor's OpenCL driver), or OCL_ICD_VENDORS points to a folder without .icd files (" +
               value("OCL_ICD_VENDORS") + ").";
    }
    std::string text = "Platforms found, none with a usable device:";
    bool pocl = false;
    for (const NamedPlatform& platform : platforms) {
        text += " " + platform.name + ";";
        pocl = pocl || platform.name == pocl_platform;
    }
    text.back() = '.';
    if (!pocl) return text + " A CPU driver that always works: package pocl-opencl-icd.";
    return text + " Usual causes with PoCL: POCL_DEVICES names a device that it does not know (" + value("POCL_DEVICES") +
           "; up to 3.x: pthread, basic; from 4.0: cpu, cpu-minimal), or its cache directory cannot be written (" +
           value("POCL_CACHE_DIR") + "; " + value("HOME") + "). POCL_DEBUG=all shows its reason.";
}

std::size_t select_device(const std::vector<DeviceInfo>& found, const std::string& selector) {
    if (found.empty()) throw DeviceError("no OpenCL device. " + no_device_advice());
    const auto first = [&](auto&& matches) {
        return static_cast<std::size_t>(std::distance(found.begin(), std::find_if(found.begin(), found.end(), matches)));
    };
    const std::string wanted = lower(trimmed(selector));
    const bool is_index = !wanted.empty() && std::all_of(wanted.begin(), wanted.end(), [](unsigned char c) { return std::isdigit(c); });

    std::size_t chosen = found.size();
    if (wanted.empty()) {
        chosen = first([](const DeviceInfo& d) { return !d.is_cpu; });
        if (chosen == found.size()) chosen = 0;
    } else if (is_index) {
        chosen = first([&](const DeviceInfo& d) { return std::to_string(d.index) == wanted; });
    } else if (wanted == "cpu" || wanted == "gpu") {
        chosen = first([&](const DeviceInfo& d) { return d.is_cpu == (wanted == "cpu"); });
    } else {
        chosen = first([&](const DeviceInfo& d) { return (lower(d.name) + "\n" + lower(d.platform)).find(wanted) != std::string::npos; });
    }
    if (chosen == found.size()) throw DeviceError("no OpenCL device matches \"" + selector + "\". Devices:" + list_text(found));
    return chosen;
}

}  // namespace pencil
