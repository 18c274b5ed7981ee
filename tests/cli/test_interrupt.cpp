// A signal stops a render at the next launch; what is finished by then is written and readable.
#include <gtest/gtest.h>
#include <signal.h>

#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {
namespace {

class Interrupt : public testing::TestWithParam<int> {};

/// A render of hours, if nobody stops it: a single one of its 512 bounces looks up 4e10 pencils. It cannot end before a signal arrives.
std::vector<std::string> long_render(const Folder& folder) {
    const std::string scene = folder.write("room.xml", small_scene());
    return {PENCIL_PROGRAM, "render", scene,     "-o",          (folder / "a.exr").string(),
            "--pencils",    "3000",   "--decay", "1",           "--resolution",
            "640x480",      "--aov",  "none",    "--tolerance", "1e-9"};
}

TEST_P(Interrupt, WritesThePartialResultWithStatus7) {
    const Folder folder;
    Child child(long_render(folder));
    ASSERT_TRUE(child.wait_for_error_text("pencil: ")) << "no progress line";
    child.send(GetParam());
    const RunResult result = child.wait();
    EXPECT_EQ(result.code, 7) << result.out << result.err;
    EXPECT_NE(result.err.find("interrupted"), std::string::npos) << result.err;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.exr", "room.xml"}));
    const std::string info = image_info(folder / "a.exr");
    EXPECT_NE(info.find("640 x  480"), std::string::npos) << info;
    EXPECT_NE(info.find("pencil:interrupted: 1"), std::string::npos) << info;
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST(InterruptTwice, EndsAtOnce) {
    const Folder folder;
    Child child(long_render(folder));
    ASSERT_TRUE(child.wait_for_error_text("pencil: "));
    child.send(SIGINT);
    child.send(SIGTERM);
    const RunResult result = child.wait();
    // However long the signals take, the render is far from its end. Both may arrive between two instructions of the program's own; then the first one wins.
    EXPECT_TRUE(result.signal == SIGTERM || result.signal == SIGINT || result.code == 7) << result.code << " " << result.signal;
}

}  // namespace
}  // namespace pencil_test
