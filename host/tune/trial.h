// Trials of profiles by turns, and what their times say. Times are those of the device, by kernel; a machine that others use, too, only ever
// adds to them.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "cl/device_profile.h"

namespace pencil {

using KernelTimes = std::map<std::string, double>;  // by kernel [s]

/// One run of the work that profiles are measured by.
struct Sample {
    KernelTimes seconds;
    std::vector<float> image;  // what came out
};

/// Runs it with a profile.
using Workload = std::function<Sample(const DeviceProfile&)>;

/// A profile, and how it did.
struct Trial {
    DeviceProfile profile;
    std::string refused;  // why it is out: wrong results, or none; empty if it is not
    std::vector<KernelTimes> rounds;
};

/// Images agree whose mean square of relative differences (image/relative_error.h) is at most this: rounding and ties of visibility are far
/// below, a wrong texel in a thousand is above.
constexpr double same_results = 1e-5;

/// Runs all profiles once to have their code made, then `rounds` times by turns, so that all meet the same disturbances. Profiles whose image
/// differs from the first's, or whose run ends with a DeviceError or MemoryError, take no part; those far slower than the first are run
/// three times only.
std::vector<Trial> try_profiles(const Workload& work, const std::vector<DeviceProfile>& profiles, int rounds);

/// Sum over some kernels, over all if none is named.
double sum_of(const KernelTimes& seconds, const std::set<std::string>& kernels);

/// Time of a trial relative to another's over some kernels, all if none is named: the ratio of the least times or the median of the rounds'
/// ratios, whichever is greater. One lucky round makes nothing win.
double time_ratio(const Trial& trial, const Trial& to, const std::set<std::string>& kernels = {});

/// How far two trials of the same profile are apart by these two measures: what the machine does to times, as a share of them.
double noise_between(const Trial& trial, const Trial& again, const std::set<std::string>& kernels = {});

}  // namespace pencil
