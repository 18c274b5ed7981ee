// Renders that are killed, lose their device or find no memory: nothing that was finished is lost, and the image is the same.
#include <gtest/gtest.h>
#include <signal.h>

#include <nlohmann/json.hpp>

#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {
namespace {

class KilledRender : public testing::Test {
protected:
    /// A render of some passes of a few hundredths of a second.
    std::vector<std::string> render(const std::string& name, const std::vector<std::string>& more) const {
        std::vector<std::string> command{PENCIL_PROGRAM,
                                         "render",
                                         scene,
                                         "-o",
                                         (folder / name).string(),
                                         "--aov",
                                         "none",
                                         "--target-error",
                                         "1e-12",
                                         "--stats",
                                         (folder / (name + ".json")).string(),
                                         "--resolution",
                                         "24x16",
                                         "--pencils",
                                         "50"};
        command.insert(command.end(), more.begin(), more.end());
        return command;
    }
    nlohmann::json stats(const std::string& name) const { return nlohmann::json::parse(read_text(folder / (name + ".json"))); }
    RunResult run_with_fault(const std::string& name, const std::string& fault, const std::vector<std::string>& more = {}) const {
        RunOptions options;
        options.environment["PENCIL_FAULT"] = fault;
        return run(render(name, more), options);
    }

    const Folder folder;
    const std::string scene = folder.write("room.xml", small_scene());
    const std::string file = (folder / "state").string();
};

TEST_F(KilledRender, KilledAgainAndAgainGivesTheSameImage) {
    ASSERT_EQ(run(render("straight.exr", {})).code, 0);
    int killed = 0;
    std::vector<std::string> more{"--checkpoint", file};
    for (; killed < 10; ++killed) {
        Child child(render("killed.exr", more));
        // Some passes further; the last launches of the pass go on while the signal comes.
        for (int pass = 0; pass < 5; ++pass)
            if (!child.wait_for_error_text("pencil: project film\n")) break;
        ::usleep(static_cast<unsigned>(1000 * (37 * killed % 100)));
        child.send(SIGKILL);
        const RunResult result = child.wait();
        if (result.signal != SIGKILL) break;  // it was faster
        if (std::filesystem::exists(file)) more = {"--checkpoint", file, "--resume", file};
    }
    EXPECT_GE(killed, 1);
    const RunResult last = run(render("killed.exr", more));
    ASSERT_EQ(last.code, 0) << last.err;
    EXPECT_EQ(largest_difference(folder / "straight.exr", folder / "killed.exr"), 0.0);
    EXPECT_EQ(stats("killed.exr")["passes"], stats("straight.exr")["passes"]);
}

TEST_F(KilledRender, AnInterruptLeavesOne) {
    Child child(render("a.exr", {"--checkpoint", file}));
    ASSERT_TRUE(child.wait_for_error_text("pencil: project film\n"));
    ::usleep(200000);
    child.send(SIGINT);
    const RunResult result = child.wait();
    ASSERT_TRUE(result.code == 7 || result.code == 0) << result.err;
    EXPECT_EQ(run(render("b.exr", {"--resume", file})).code, 0);
}

TEST_F(KilledRender, WhatCannotGoOnIsStatus2) {
    EXPECT_EQ(run(render("a.exr", {"--resume", (folder / "none").string()})).code, 2);
    EXPECT_EQ(run(render("a.exr", {"--resume", scene})).code, 2);
    const RunResult line = run_pencil({"render", scene, "-o", (folder / "a.exr").string(), "--method", "line", "--checkpoint", file});
    EXPECT_EQ(line.code, 2);
    EXPECT_NE(line.err.find("--checkpoint"), std::string::npos) << line.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "a.exr"));
}

TEST_F(KilledRender, AFolderThatCannotBeWrittenIsSeenFirst) {
    const RunResult result = run(render("a.exr", {"--checkpoint", (folder / "none" / "state").string()}));
    EXPECT_EQ(result.code, 6) << result.err;
}

TEST_F(KilledRender, ALostDeviceLeavesWhatIsFinished) {
    const RunResult result = run_with_fault("a.exr", "lost:400", {"--checkpoint", file});
    EXPECT_EQ(result.code, 4) << result.err;
    EXPECT_NE(result.err.find("what was finished is written"), std::string::npos) << result.err;
    EXPECT_GT(stats("a.exr")["passes"], 0);
    EXPECT_EQ(run(render("b.exr", {"--resume", file})).code, 0) << "the checkpoint is whole";
}

TEST_F(KilledRender, ADeviceLostBeforeAnImageIsStatus4) {
    const RunResult result = run_with_fault("a.exr", "lost:2");
    EXPECT_EQ(result.code, 4) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "a.exr"));
}

TEST_F(KilledRender, AnotherDeviceGoesOn) {
    ASSERT_EQ(run(render("straight.exr", {})).code, 0);
    RunOptions two;
    two.environment = {{"POCL_DEVICES", "basic pthread"}, {"PENCIL_FAULT", "lost:400"}};
    const RunResult result = run(render("a.exr", {}), two);
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.err.find("goes on"), std::string::npos) << result.err;
    EXPECT_EQ(stats("a.exr")["passes"], stats("straight.exr")["passes"]);
    EXPECT_LT(largest_difference(folder / "straight.exr", folder / "a.exr"), 1e-5);
    two.environment["PENCIL_DEVICE"] = "";
    EXPECT_EQ(run(render("b.exr", {"--device", "0"}), two).code, 4) << "a device that was named is not replaced";
}

TEST_F(KilledRender, DevicesThatShareARenderGiveTheSameImageWhicheverFails) {
    ASSERT_EQ(run(render("straight.exr", {})).code, 0);
    RunOptions two;
    two.environment["POCL_DEVICES"] = "basic pthread";
    const RunResult shared = run(render("shared.exr", {"--device", "0,1"}), two);
    ASSERT_EQ(shared.code, 0) << shared.err;
    EXPECT_EQ(largest_difference(folder / "straight.exr", folder / "shared.exr"), 0.0);
    const nlohmann::json pencils = stats("shared.exr")["device_pencils"];
    ASSERT_EQ(pencils.size(), 2) << pencils;
    for (const auto& of_device : pencils) EXPECT_GT(of_device.get<int>(), 0) << pencils;
    for (const std::string fault : {"lost:300@2", "memory:60+@2", "lost:400@1"}) {
        two.environment["PENCIL_FAULT"] = fault;
        const RunResult result = run(render("a.exr", {"--device", "0,1"}), two);
        ASSERT_EQ(result.code, 0) << fault << result.err;
        EXPECT_NE(result.err.find("PENCIL_FAULT"), std::string::npos) << fault << result.err;
        EXPECT_EQ(largest_difference(folder / "straight.exr", folder / "a.exr"), 0.0) << fault;
    }
    EXPECT_EQ(run(render("b.exr", {"--device", "0,0"}), two).code, 2);
    EXPECT_EQ(run(render("b.exr", {"--device", "0,1", "--method", "line"}), two).code, 2);
}

TEST_F(KilledRender, ShortMemoryIsTriedAgainWithLess) {
    const RunResult result = run_with_fault("a.exr", "memory:200");
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.err.find("device memory is short"), std::string::npos) << result.err;
    const RunResult never = run_with_fault("b.exr", "memory:900+");
    ASSERT_EQ(never.code, 0) << never.err;
    EXPECT_NE(never.err.find("stopped after"), std::string::npos) << never.err;
    EXPECT_TRUE(std::filesystem::exists(folder / "b.exr"));
    EXPECT_EQ(run_with_fault("c.exr", "memory:1+").code, 5);
    EXPECT_EQ(run_with_fault("c.exr", "sunspots").code, 2);
}

}  // namespace
}  // namespace pencil_test
