// How the kernels of a device are built and launched, as far as that is a matter of speed: numbers that follow from what the device says of
// itself, or that `pencil tune` has measured. Results depend on none of them beyond rounding.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>

namespace pencil {

struct DeviceInfo;

struct DeviceProfile {
    int packet_width = 1;                       // PENCIL_WIDTH: surfels of a packet, 1, 4, 8 or 16
    int block = 1;                              // PENCIL_BLOCK: packets per work-item, a power of two
    std::size_t group = 1;                      // work-items per work-group, a power of two
    std::map<std::string, std::size_t> groups;  // the same of kernels that are faster with another number
    /// Time of each way to make geometry maps (visibility/visibility_path.h) relative to what its cost model says.
    std::array<double, 3> map_costs{1, 1, 1};
    bool atlas_image = false;  // --atlas auto: radiance maps are looked up as an image
    bool tuned = false;        // measured, not generic

    std::size_t group_of(const std::string& kernel) const {
        const auto own = groups.find(kernel);
        return own == groups.end() ? group : own->second;
    }
};

/// Surfels of a work-item at most: buffers of surfels end at multiples of it.
constexpr int most_lanes = 128;

/// Packets per work-item of this width: enough on CPUs to reuse what the caches hold, one where work-items are narrow.
constexpr int generic_block(int packet_width) { return packet_width > 1 ? 8 : 1; }

/// True if so many triangles are met by single rays rather than by packets (shared/bvh.h): where they are many, the rays of a packet part soon.
/// $PENCIL_WIDE_BVH, 0 or 1, decides instead; UsageError if it is something else.
bool wants_wide_bvh(int packet_width, std::size_t triangles);

/// By the device's properties alone. Width: native float width on CPUs of 4, 16 on wider ones, 1 elsewhere.
DeviceProfile generic_profile(const DeviceInfo& info);

/// Work-items per group that a profile may ask for: CPU drivers keep the private memory of a whole group on the stack of a thread.
std::size_t most_group(const DeviceInfo& info);

/// What is wrong with a profile's numbers for this device; empty if nothing is.
std::string trouble_of(const DeviceProfile& profile, const DeviceInfo& info);

}  // namespace pencil
