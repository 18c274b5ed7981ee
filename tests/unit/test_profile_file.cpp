// Tuned profiles on disk: given back to the same device and driver, to none other, and never with numbers that nobody could have measured.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cl/profile_file.h"

namespace {

using namespace pencil;
using Json = nlohmann::ordered_json;

class ProfileOnDisk : public testing::Test {
protected:
    void SetUp() override {
        before_ = std::getenv("XDG_CACHE_HOME") ? std::getenv("XDG_CACHE_HOME") : "";
        folder_ = std::filesystem::temp_directory_path() / ("pencil-profile-" + std::to_string(getpid()));
        setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
        info_.platform = "A platform";
        info_.name = "a device";
        info_.driver = "1.0";
        info_.is_cpu = true;
        info_.native_float_width = 16;
        info_.max_work_group = 4096;
        profile_ = generic_profile(info_);
        profile_.packet_width = 8;
        profile_.block = 16;
        profile_.groups = {{"light_surfels", 32}};
        profile_.map_costs = {1, 0.5, 2};
        profile_.atlas_image = true;
    }
    void TearDown() override {
        std::filesystem::remove_all(folder_);
        before_.empty() ? unsetenv("XDG_CACHE_HOME") : setenv("XDG_CACHE_HOME", before_.c_str(), 1);
    }
    /// What is read after the file was changed.
    ReadProfile changed(const std::function<void(Json&)>& change) {
        const std::filesystem::path file = write_profile(info_, profile_);
        Json json = Json::parse(std::ifstream(file));
        change(json);
        std::ofstream(file) << json.dump();
        return read_profile(info_);
    }
    void expect_ignored(const ReadProfile& read, const std::string& reason) {
        EXPECT_FALSE(read.profile) << reason;
        EXPECT_NE(read.trouble.find(reason), std::string::npos) << read.trouble;
        EXPECT_NE(read.trouble.find(folder_.string()), std::string::npos) << read.trouble;
    }
    std::filesystem::path folder_;
    std::string before_;
    DeviceInfo info_;
    DeviceProfile profile_;
};

TEST_F(ProfileOnDisk, ComesBackWhole) {
    EXPECT_FALSE(read_profile(info_).profile);
    EXPECT_FALSE(std::filesystem::exists(folder_)) << "reading makes no folder";
    write_profile(info_, profile_);
    const ReadProfile read = read_profile(info_);
    ASSERT_TRUE(read.profile) << read.trouble;
    EXPECT_EQ(read.profile->packet_width, 8);
    EXPECT_EQ(read.profile->block, 16);
    EXPECT_EQ(read.profile->group, profile_.group);
    EXPECT_EQ(read.profile->groups, profile_.groups);
    EXPECT_EQ(read.profile->map_costs, profile_.map_costs);
    EXPECT_TRUE(read.profile->atlas_image);
    EXPECT_TRUE(read.profile->tuned);
}

TEST_F(ProfileOnDisk, IsOfOneDeviceDriverAndVersion) {
    write_profile(info_, profile_);
    DeviceInfo other = info_;
    other.driver = "1.1";
    EXPECT_FALSE(read_profile(other).profile);
    EXPECT_TRUE(read_profile(other).trouble.empty()) << "it has none";
    expect_ignored(changed([](Json& json) { json["device"]["driver"] = "0.9"; }), "another device or driver");
    expect_ignored(changed([](Json& json) { json["kernels"] = "0123456789abcdef"; }), "other kernels");
    expect_ignored(changed([](Json& json) { json["schema"] = 99; }), "another format");
}

TEST_F(ProfileOnDisk, NumbersOutOfRangeAreNotUsed) {
    const auto with = [&](const char* name, const Json& value) { return changed([&](Json& json) { json["profile"][name] = value; }); };
    for (const Json& wrong : {Json(0), Json(2), Json(17), Json(1 << 15)}) expect_ignored(with("packet_width", wrong), "out of range");
    for (const Json& wrong : {Json(0), Json(3), Json(32)}) expect_ignored(with("block", wrong), "out of range");
    for (const Json& wrong : {Json(0), Json(7), Json(128), Json(8192)}) expect_ignored(with("group", wrong), "out of range");
    expect_ignored(with("groups", {{"light_surfels", 5}}), "out of range");
    expect_ignored(with("groups", {{"../no kernel", 8}}), "out of range");
    for (const Json& cost : {Json(0.0), Json(-1), Json(1e9)})
        expect_ignored(with("map_costs", {{"rasterize", 1}, {"clusters", cost}, {"trace", 1}}), "out of range");
    for (const Json& value : {Json(-1), Json(8.5), Json("8"), Json(nullptr), Json(1ULL << 40), Json::array({8})})
        expect_ignored(with("packet_width", value), "damaged");
    expect_ignored(with("groups", 3), "damaged");
    expect_ignored(with("map_costs", {{"rasterize", 1}}), "damaged");
}

TEST_F(ProfileOnDisk, DamagedFilesAreNotUsed) {
    const std::filesystem::path file = write_profile(info_, profile_);
    std::ifstream in(file);
    const std::string whole{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    for (std::size_t length = 0; length + 2 < whole.size(); length += 7) {
        std::ofstream(file) << whole.substr(0, length);
        EXPECT_FALSE(read_profile(info_).profile) << length;
        EXPECT_FALSE(read_profile(info_).trouble.empty()) << length;
    }
    std::ofstream(file) << std::string(1 << 20, '[');
    expect_ignored(read_profile(info_), "too long");
}

TEST_F(ProfileOnDisk, IsNotTakenFromOthers) {
    const std::filesystem::path file = write_profile(info_, profile_);
    std::filesystem::permissions(file, std::filesystem::perms::all);
    expect_ignored(read_profile(info_), "others may write it");
}

TEST_F(ProfileOnDisk, ComesBackWhateverTheUmask) {
    const mode_t before = umask(002);
    write_profile(info_, profile_);
    umask(before);
    EXPECT_TRUE(read_profile(info_).profile.has_value());
}

TEST_F(ProfileOnDisk, IsNotUsedUnlessAllowed) { EXPECT_FALSE(tuned_profiles_allowed()) << "tests do not depend on who has tuned what"; }

}  // namespace
