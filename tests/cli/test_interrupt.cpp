// A signal stops a render at the next launch; what is finished by then is written and readable.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>

#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {
namespace {

class Interrupt : public testing::TestWithParam<int> {};

/// A render that never ends by itself.
std::vector<std::string> endless_render(const Folder& folder) {
    const std::string scene = folder.write("room.xml", small_scene());
    return {PENCIL_PROGRAM, "render",       scene,    "-o",        (folder / "a.exr").string(),
            "--method",     "surface",      "--time", "1e6",       "--aov",
            "none",         "--resolution", "96x64",  "--pencils", "100"};
}

/// The last stage that is new: all kernels are built. A signal while the driver builds one may take the driver's own files away.
constexpr const char* all_is_built = "pencil: project film\n";

void expect_partial_result(const RunResult& result, const Folder& folder, const std::string& size) {
    EXPECT_EQ(result.code, 7) << result.out << result.err;
    EXPECT_NE(result.err.find("interrupted"), std::string::npos) << result.err;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.exr", "room.xml"}));
    const std::string info = image_info(folder / "a.exr");
    EXPECT_NE(info.find(size), std::string::npos) << info;
    EXPECT_NE(info.find("pencil:interrupted: 1"), std::string::npos) << info;
}

TEST_P(Interrupt, WritesThePartialResultWithStatus7) {
    const Folder folder;
    Child child(endless_render(folder));
    ASSERT_TRUE(child.wait_for_error_text(all_is_built)) << "no such progress line";
    child.send(GetParam());
    expect_partial_result(child.wait(), folder, "96 x   64");
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, testing::Values(SIGINT, SIGTERM, SIGHUP));

/// Line projection, whose first bounce is the last new stage; it has 500 of them, and looks up 2e7 pencils in each.
TEST(InterruptLine, WritesThePartialResultWithStatus7) {
    const Folder folder;
    const std::string scene = folder.write("room.xml", small_scene());
    Child child({PENCIL_PROGRAM, "render", scene, "-o", (folder / "a.exr").string(), "--pencils", "256", "--map", "16", "--decay", "1",
                 "--bounces", "500", "--aov", "none"});
    ASSERT_TRUE(child.wait_for_error_text("pencil: pencil transport\n")) << "no such progress line";
    child.send(SIGINT);
    expect_partial_result(child.wait(), folder, "24 x   16");
}

/// A layer that was not reached: its file is left out, the others are written.
TEST(InterruptLayers, WhatHasNoLayerYetIsLeftOut) {
    for (const std::string command : {"render", "reference"}) {
        const Folder folder;
        const std::string scene = folder.write("room.xml", small_scene());
        const std::string last_stage = command == "render" ? all_is_built : "pencil: trace paths\n";
        Child child({PENCIL_PROGRAM, command, scene, "-o", (folder / "a.illuminance.png").string(), "-o", (folder / "a.exr").string(),
                     "--time", "1e6", "--aov", "none"});
        ASSERT_TRUE(child.wait_for_error_text(last_stage)) << command;
        child.send(SIGINT);
        const RunResult result = child.wait();
        EXPECT_NE(result.err.find("a.illuminance.png is not written: interrupted before there was a layer illuminance"), std::string::npos)
            << result.err;
        EXPECT_EQ(result.out.find("illuminance"), std::string::npos) << result.out;
        expect_partial_result(result, folder, "24 x   16");
    }
}

TEST(InterruptLayers, NothingIsLeft) {
    const Folder folder;
    const std::string scene = folder.write("room.xml", small_scene());
    Child child({PENCIL_PROGRAM, "reference", scene, "-o", (folder / "a.illuminance.png").string(), "--time", "1e6"});
    ASSERT_TRUE(child.wait_for_error_text("pencil: trace paths\n"));
    child.send(SIGINT);
    const RunResult result = child.wait();
    EXPECT_EQ(result.code, 7) << result.err;
    EXPECT_NE(result.err.find("interrupted; nothing is written"), std::string::npos) << result.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"room.xml"});
}

/// What was measured by then, however little is known of it.
TEST(InterruptMeasure, WritesTheTableWithStatus7) {
    const Folder folder;
    const std::string scene = folder.write("room.xml", small_scene());
    for (const std::string method : {"surface", "reference"}) {
        const std::string last_stage = method == "surface" ? all_is_built : "pencil: trace paths\n";
        Child child({PENCIL_PROGRAM, "measure", scene, "--grid", "-1,-1,0.1;2,0,0;0,2,0;4;4", "--method", method, "--time", "1e6"});
        ASSERT_TRUE(child.wait_for_error_text(last_stage)) << method;
        child.send(SIGINT);
        const RunResult result = child.wait();
        EXPECT_EQ(result.code, 7) << result.err;
        EXPECT_NE(result.err.find("interrupted; what was measured until then is written"), std::string::npos) << result.err;
        EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1 + 16) << result.out;
    }
}

TEST(InterruptTwice, EndsAtOnce) {
    const Folder folder;
    Child child(endless_render(folder));
    ASSERT_TRUE(child.wait_for_error_text(all_is_built));
    child.send(SIGINT);
    child.send(SIGTERM);
    const RunResult result = child.wait();
    // Both may arrive between two instructions of the program's own; then the first one wins.
    EXPECT_TRUE(result.signal == SIGTERM || result.signal == SIGINT || result.code == 7) << result.code << " " << result.signal;
}

}  // namespace
}  // namespace pencil_test
