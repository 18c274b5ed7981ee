// The search for the profile of a device (cl/device_profile.h): packet width, packets per work-item, form of the radiance maps,
// work-items per group of each kernel.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cl/device.h"
#include "tune/trial.h"

namespace pencil {

/// A variant must take less time than what it replaces by this share, and by twice the noise, which a second trial of what it replaces tells.
constexpr double win_margin = 0.07;
/// What is stored needs to win by less than something new: a choice that is as good as another does not change from run to run.
constexpr double stay_margin = 0.5 * win_margin;

/// What was tried for some kernels.
struct TuneRow {
    std::string kernels, variant;
    double ratio = 1;     // time relative to what was chosen before
    std::string outcome;  // "kept", "", or why it was refused
};

struct Tuned {
    DeviceProfile profile;
    std::vector<TuneRow> rows;
};

struct TuneRules {
    int rounds = 7;
    bool images = false;                  // the device has images for radiance maps
    std::optional<DeviceProfile> stored;  // what an earlier search has found
    std::function<void(const std::string&)> stage;
};

/// Tries one kind of number after the other, each beside the best so far, then all that was found beside the generic profile: what is not
/// faster by win_margin there is not kept. What is `stored` stays unless it does not win any more, or something else is faster by as much.
Tuned tune_launches(const Workload& work, const DeviceInfo& info, const TuneRules& rules);

}  // namespace pencil
