// The file repeats what it was measured on, so that one that was copied, or is older than the driver, is known; every number is checked before
// it is used, whoever wrote it.
#include "cl/profile_file.h"

#include <fmt/format.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <system_error>

#include "cl/embedded_kernels.h"
#include "cl/private_cache.h"
#include "util/environment.h"
#include "util/error.h"
#include "util/fingerprint.h"
#include "util/output_file.h"

namespace pencil {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int profile_schema = 1;
constexpr std::size_t largest_profile = 1 << 16;
constexpr const char* folder_name = "profiles";
constexpr std::array<const char*, 3> map_paths{"rasterize", "clusters", "trace"};  // as in VisibilityPath

bool& allowed() {
    static bool is_allowed = false;
    return is_allowed;
}

/// What the numbers hold for, beside the kernels.
Json identity_json(const DeviceInfo& info) {
    return {
        {"platform", info.platform}, {"device", info.name}, {"vendor", info.vendor}, {"version", info.version}, {"driver", info.driver}};
}

/// Of all kernel texts: measured with others, numbers say little.
std::string kernels_fingerprint() {
    Fingerprint print;
    for (const auto& [file, text] : embedded_kernels()) {
        print.add_bytes(file.data(), file.size());
        print.add_bytes(text, std::strlen(text));
    }
    return print.text();
}

std::string json_text(const Json& json, int indent = -1) { return json.dump(indent, ' ', false, Json::error_handler_t::replace); }

fs::path file_of(const fs::path& folder, const DeviceInfo& info) {
    const std::string identity = json_text(identity_json(info));
    return folder / (fingerprint(identity.data(), identity.size()) + ".json");
}

/// A whole number; Json::exception if it is none.
template <typename T>
T whole(const Json& json) {
    if (!json.is_number_unsigned() || json.get<std::uint64_t>() > largest_profile)
        throw std::out_of_range(json_text(json) + " is no small whole number");
    return static_cast<T>(json.get<std::uint64_t>());
}

DeviceProfile profile_of(const Json& json) {
    DeviceProfile profile;
    profile.packet_width = whole<int>(json.at("packet_width"));
    profile.block = whole<int>(json.at("block"));
    profile.group = whole<std::size_t>(json.at("group"));
    for (const auto& [kernel, group] : json.at("groups").get_ref<const Json::object_t&>())
        profile.groups[kernel] = whole<std::size_t>(group);
    for (std::size_t i = 0; i < map_paths.size(); ++i) profile.map_costs[i] = json.at("map_costs").at(map_paths[i]).get<double>();
    profile.atlas_image = json.at("atlas_image").get<bool>();
    profile.tuned = true;
    return profile;
}

Json profile_json(const DeviceProfile& profile) {
    Json groups = Json::object(), costs = Json::object();
    for (const auto& [kernel, group] : profile.groups) groups[kernel] = group;
    for (std::size_t i = 0; i < map_paths.size(); ++i) costs[map_paths[i]] = profile.map_costs[i];
    return {{"packet_width", profile.packet_width}, {"block", profile.block}, {"group", profile.group}, {"groups", groups},
            {"atlas_image", profile.atlas_image},   {"map_costs", costs}};
}

ReadProfile parsed(const std::string& text, const DeviceInfo& info) {
    try {
        const Json json = Json::parse(text);
        if (json.at("schema") != profile_schema) return {{}, "it has another format"};
        if (json.at("device") != Json::parse(json_text(identity_json(info)))) return {{}, "it is of another device or driver"};
        if (json.at("kernels") != kernels_fingerprint()) return {{}, "it was measured with other kernels; `pencil tune` measures these"};
        const DeviceProfile profile = profile_of(json.at("profile"));
        const std::string trouble = trouble_of(profile, info);
        return trouble.empty() ? ReadProfile{profile, ""} : ReadProfile{{}, trouble + ", which is out of range"};
    } catch (const std::exception& error) {  // what Json throws, and whole()
        return {{}, std::string("it is damaged: ") + error.what()};
    }
}

}  // namespace

void allow_tuned_profiles() { allowed() = environment("PENCIL_TUNED") != "0"; }
bool tuned_profiles_allowed() { return allowed(); }

ReadProfile read_profile(const DeviceInfo& info) {
    const fs::path folder = private_cache(folder_name, false);
    if (folder.empty()) return {};
    const fs::path file = file_of(folder, info);
    std::error_code none;
    if (!fs::exists(fs::symlink_status(file, none))) return {};
    const std::vector<char> bytes = read_private(file, largest_profile);
    ReadProfile read = bytes.empty() ? ReadProfile{{}, "it is empty, too long, or others may write it"}
                                     : parsed(std::string(bytes.begin(), bytes.end()), info);
    if (!read.trouble.empty()) read.trouble = fmt::format("the tuned profile {} is ignored: {}", file.string(), read.trouble);
    return read;
}

fs::path profile_folder() {
    fs::path folder = private_cache(folder_name, true);
    if (folder.empty())
        throw OutputError(
            "no folder for profiles: neither XDG_CACHE_HOME nor HOME names a place where pencil/profiles is this user's alone");
    return folder;
}

fs::path write_profile(const DeviceInfo& info, const DeviceProfile& profile) {
    const Json json{{"schema", profile_schema},
                    {"device", identity_json(info)},
                    {"kernels", kernels_fingerprint()},
                    {"profile", profile_json(profile)}};
    const std::string text = json_text(json, 2) + "\n";
    fs::path file = file_of(profile_folder(), info);
    write_private_file(file, text.data(), text.size());
    return file;
}

}  // namespace pencil
