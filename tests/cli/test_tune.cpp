// Tuned profiles from outside: renders use them and say so, and never need them.
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cl/profile_file.h"
#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {
namespace {

/// Other sums, but the same image beyond rounding.
constexpr double same_image = 1e-5;

class TunedDevice : public testing::Test {
protected:
    /// A profile for the device of the tests, in a cache of the test's own.
    void SetUp() override {
        const char* before = std::getenv("XDG_CACHE_HOME");
        const std::string kept = before ? before : "";
        setenv("XDG_CACHE_HOME", folder_.path().c_str(), 1);
        const pencil::DeviceInfo info = pencil::Device::open("")->info();
        pencil::DeviceProfile profile = pencil::generic_profile(info);
        profile.packet_width = profile.packet_width == 8 ? 4 : 8;
        profile.block = 4;
        file_ = pencil::write_profile(info, profile);
        kept.empty() ? unsetenv("XDG_CACHE_HOME") : setenv("XDG_CACHE_HOME", kept.c_str(), 1);
        width_ = profile.packet_width;
        scene_ = folder_.write("room.xml", small_scene());
    }
    /// Renders; what --stats says of the profile is in profile().
    RunResult render(const std::string& name, const std::string& tuned) {
        std::vector<std::string> arguments{"render", scene_, "-o", (folder_ / name).string(), "--stats", (folder_ / "stats.json").string()};
        arguments.insert(arguments.end(), quick().begin(), quick().end());
        RunOptions options;
        options.environment = {{"XDG_CACHE_HOME", folder_.path().string()}, {"PENCIL_TUNED", tuned}};
        return run_pencil(arguments, options);
    }
    nlohmann::json profile() const { return nlohmann::json::parse(std::ifstream(folder_ / "stats.json"))["device"]["profile"]; }

    Folder folder_;
    std::filesystem::path file_;
    std::string scene_;
    int width_ = 0;
};

TEST_F(TunedDevice, IsUsedByRendersUnlessForbidden) {
    ASSERT_EQ(render("generic.exr", "0").code, 0);
    EXPECT_EQ(profile()["tuned"], false);
    EXPECT_NE(profile()["packet_width"], width_);
    ASSERT_EQ(render("tuned.exr", "1").code, 0);
    EXPECT_EQ(profile()["tuned"], true);
    EXPECT_EQ(profile()["packet_width"], width_);
    EXPECT_EQ(profile()["block"], 4);
    const double difference = largest_difference(folder_ / "generic.exr", folder_ / "tuned.exr");
    EXPECT_GE(difference, 0);
    EXPECT_LE(difference, same_image);
}

TEST_F(TunedDevice, DamagedFilesAreNamedAndIgnored) {
    ASSERT_EQ(render("generic.exr", "0").code, 0);
    const std::string whole = read_text(file_);
    for (const std::string& text : {std::string("{"), std::string(), whole.substr(0, whole.size() / 2),
                                    std::string(whole).replace(whole.find("\"block\": 4"), 10, "\"block\": 5")}) {
        std::ofstream(file_) << text;
        const RunResult result = render("damaged.exr", "1");
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_NE(result.err.find(file_.string()), std::string::npos) << result.err;
        EXPECT_NE(result.err.find("ignored"), std::string::npos) << result.err;
        EXPECT_EQ(profile()["tuned"], false);
        EXPECT_EQ(largest_difference(folder_ / "generic.exr", folder_ / "damaged.exr"), 0);
    }
}

TEST_F(TunedDevice, AnInterruptedTuningChangesNothing) {
    const std::string before = read_text(file_);
    RunOptions options;
    options.environment = {{"XDG_CACHE_HOME", folder_.path().string()}, {"PENCIL_TUNED", "1"}};
    Child child({PENCIL_PROGRAM, "tune"}, options);
    ASSERT_TRUE(child.wait_for_error_text("tuning: size of the work"));
    child.send(SIGINT);
    const RunResult result = child.wait();
    EXPECT_EQ(result.code, 7) << result.err;
    EXPECT_EQ(read_text(file_), before);
}

TEST(Tune, WithoutAPlaceForItsResultIsRefusedAtOnce) {
    const Folder folder;
    RunOptions options;
    options.environment = {{"XDG_CACHE_HOME", folder.write("file", "no folder")}};
    const RunResult result = run_pencil({"tune"}, options);
    EXPECT_EQ(result.code, 6) << result.err;
    EXPECT_NE(result.err.find("XDG_CACHE_HOME"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace pencil_test
