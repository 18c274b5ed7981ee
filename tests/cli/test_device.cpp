// The device from outside: listing, self-test, none at all, and the same image however PoCL is told to run.
#include <gtest/gtest.h>

#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {
namespace {

/// Threads and vectorising driver may change the order of a few additions within a kernel, no more.
constexpr double same_image = 1e-5;

TEST(Device, ListShowsAtLeastOneThatPassesItsSelfTest) {
    const RunResult result = run_pencil({"devices", "--self-test"});
    EXPECT_EQ(result.code, 0) << result.out << result.err;
    EXPECT_EQ(result.out.rfind("0  ", 0), 0U) << result.out;
    EXPECT_NE(result.out.find("passed"), std::string::npos) << result.out;
    EXPECT_EQ(result.out.find("FAILED"), std::string::npos) << result.out;
}

TEST(Device, NoPlatformIsStatus4WithAdvice) {
    const Folder empty;
    const std::string scene = empty.write("room.xml", small_scene());
    RunOptions none;
    none.environment["OCL_ICD_VENDORS"] = empty.path().string() + "/";
    const RunResult result = run_pencil({"render", scene, "-o", (empty / "a.exr").string()}, none);
    EXPECT_EQ(result.code, 4) << result.err;
    EXPECT_NE(result.err.find("OCL_ICD_VENDORS"), std::string::npos) << result.err;
    EXPECT_EQ(empty.names(), std::vector<std::string>{"room.xml"});
    EXPECT_EQ(run_pencil({"devices"}, none).code, 4);
    EXPECT_EQ(run_pencil({"info", scene}, none).code, 0) << "a scene can be looked at without a device";
}

TEST(Device, NoDeviceOfThePlatformIsStatus4) {
    RunOptions none;
    none.environment["POCL_DEVICES"] = "bogus";
    const RunResult result = run_pencil({"devices"}, none);
    EXPECT_EQ(result.code, 4) << result.out;
    EXPECT_NE(result.err.find("POCL_DEVICES"), std::string::npos) << result.err;
}

TEST(Device, UnknownSelectorIsStatus4AndListsWhatExists) {
    const Folder folder;
    const std::string scene = folder.write("room.xml", small_scene());
    const RunResult result = run_pencil({"render", scene, "-o", (folder / "a.exr").string(), "--device", "abacus"});
    EXPECT_EQ(result.code, 4) << result.err;
    EXPECT_NE(result.err.find("abacus"), std::string::npos) << result.err;
}

TEST(Device, ThreadsAndDriverDoNotChangeTheImage) {
    const Folder folder;
    const std::string scene = folder.write("room.xml", small_scene());
    const auto render = [&](const std::string& name, const std::map<std::string, std::string>& environment) {
        std::vector<std::string> arguments{"render", scene, "--quiet", "-o", (folder / name).string()};
        arguments.insert(arguments.end(), quick().begin(), quick().end());
        RunOptions options;
        options.environment = environment;
        return run_pencil(arguments, options);
    };
    ASSERT_EQ(render("all.exr", {}).code, 0);
    ASSERT_EQ(render("one.exr", {{"POCL_MAX_PTHREAD_COUNT", "1"}}).code, 0);
    ASSERT_EQ(render("basic.exr", {{"POCL_DEVICES", "basic"}}).code, 0);
    for (const char* other : {"one.exr", "basic.exr"}) {
        const double difference = largest_difference(folder / "all.exr", folder / other);
        EXPECT_GE(difference, 0) << other;
        EXPECT_LE(difference, same_image) << other;
    }
}

}  // namespace
}  // namespace pencil_test
