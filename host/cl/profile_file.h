// Files of tuned profiles: one for each device and driver, $XDG_CACHE_HOME/pencil/profiles/NAME.json (else ~/.cache).
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cl/device.h"
#include "cl/device_profile.h"

namespace pencil {

/// From now on devices are opened with the profile that was measured for them, unless $PENCIL_TUNED is 0. Before, with the generic one: what
/// tests and other programs measure does not depend on who has tuned what.
void allow_tuned_profiles();
bool tuned_profiles_allowed();

/// A profile or the reason why a file that is there is not used; neither if there is no file.
struct ReadProfile {
    std::optional<DeviceProfile> profile;
    std::string trouble;
};

/// The profile of a device. A file of another device, driver or version of the kernels, a damaged one, and one with a number that is out of
/// range are of no use.
ReadProfile read_profile(const DeviceInfo& info);

/// Where profiles are written, made if absent; OutputError if there is no such place.
std::filesystem::path profile_folder();

/// Replaces it; its file. OutputError.
std::filesystem::path write_profile(const DeviceInfo& info, const DeviceProfile& profile);

}  // namespace pencil
