#include "cl/device_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cl/device.h"
#include "util/environment.h"
#include "util/error.h"

namespace pencil {
namespace {

// A CPU work-item handles a whole packet, so few make a group; 64 is a full wave on every GPU.
constexpr std::size_t cpu_group = 8, gpu_group = 64;
// Groups of 64 with 16 KiB of private memory each are what PoCL's thread stacks are known to bear.
constexpr std::size_t most_cpu_group = 64, most_gpu_group = 1024;
// At 15 000 triangles either form of hierarchy may be faster, the other by up to 1.3; at 100 000 the wide one takes 0.7 of the time (docs/performance.md).
constexpr std::size_t many_triangles = 20000;
constexpr std::size_t most_kernels = 200, longest_name = 64;
// Of two devices: more would be a file that was not measured.
constexpr double most_cost = 1e3;

bool is_power_of_two(std::size_t n) { return n > 0 && (n & (n - 1)) == 0; }

bool is_kernel_name(const std::string& name) {
    return !name.empty() && name.size() <= longest_name &&
           std::all_of(
               name.begin(), name.end(), [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; });
}

}  // namespace

DeviceProfile generic_profile(const DeviceInfo& info) {
    DeviceProfile profile;
    // Twice the registers of an 8-wide CPU still pays: the per-packet work is shared by more surfels.
    profile.packet_width = !info.is_cpu ? 1 : info.native_float_width >= 8 ? 16 : 4;
    profile.block = generic_block(profile.packet_width);
    profile.group = std::min(info.is_cpu ? cpu_group : gpu_group, std::max<std::size_t>(info.max_work_group, 1));
    return profile;
}

bool wants_wide_bvh(int packet_width, std::size_t triangles) {
    const std::string text = environment("PENCIL_WIDE_BVH");
    if (text.empty()) return packet_width > 1 && triangles >= many_triangles;
    if (text != "0" && text != "1") throw UsageError("PENCIL_WIDE_BVH=" + text + " is not 0 or 1");
    return text == "1";
}

std::size_t most_group(const DeviceInfo& info) {
    return std::min(info.is_cpu ? most_cpu_group : most_gpu_group, std::max<std::size_t>(info.max_work_group, 1));
}

std::string trouble_of(const DeviceProfile& profile, const DeviceInfo& info) {
    const auto bad_group = [&](std::size_t group) {
        return group != generic_profile(info).group && (!is_power_of_two(group) || group > most_group(info));
    };
    const int width = profile.packet_width;
    if (width != 1 && width != 4 && width != 8 && width != 16) return fmt::format("packet_width is {}", width);
    if (profile.block < 1 || !is_power_of_two(static_cast<std::size_t>(profile.block)) || profile.block > most_lanes / width)
        return fmt::format("block is {} with packets of {}", profile.block, width);
    if (bad_group(profile.group)) return fmt::format("group is {}", profile.group);
    if (profile.groups.size() > most_kernels) return fmt::format("it names {} kernels", profile.groups.size());
    for (const auto& [kernel, group] : profile.groups)
        if (!is_kernel_name(kernel) || bad_group(group)) return fmt::format("group of kernel \"{}\" is {}", kernel, group);
    for (const double cost : profile.map_costs)
        if (!(cost >= 1 / most_cost && cost <= most_cost)) return fmt::format("a cost of maps is {}", cost);
    return "";
}

}  // namespace pencil
