// `pencil reference` from outside: layers and header of the image, repeatability, refusals, interruption.
#include <gtest/gtest.h>
#include <signal.h>

#include <nlohmann/json.hpp>

#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {
namespace {

class Reference : public testing::Test {
protected:
    RunResult trace(const std::vector<std::string>& more) const {
        std::vector<std::string> arguments{"reference", scene, "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_pencil(arguments);
    }
    std::string file(const std::string& name) const { return (folder / name).string(); }

    Folder folder;
    std::string scene = folder.write("room.xml", small_scene());
};

TEST_F(Reference, HasAllLayersAndTellsHowItWasMade) {
    const RunResult result =
        run_pencil({"reference", "-o", file("a.exr"), "--spp", "32", "--seed", "7", scene, "-o", file("a.png"), "--aov", "all"});
    ASSERT_EQ(result.code, 0) << result.err;
    const std::string info = image_info(file("a.exr"));
    for (const char* text :
         {"24 x   16", "float openexr", "R, G, B,", "emission.R", "direct.R, direct.G, direct.B", "bounce2.R", "albedo.G",
          "normal.X, normal.Y, normal.Z", "depth.Z", "position.X", "variance.R", "pencil:version", "pencil:method: \"path tracing\"",
          "pencil:scene: \"room.xml\"", "pencil:spp: 32", "pencil:maxDepth: \"auto\"", "pencil:seed: \"7\""}) {
        EXPECT_NE(info.find(text), std::string::npos) << text << "\n" << info;
    }
    EXPECT_EQ(info.find("Seconds"), std::string::npos) << "times only with --stats";
    EXPECT_NE(image_info(file("a.png")).find("3 channel, uint8 png"), std::string::npos);
    for (const char* text : {"paths    12288, ", "rays     ", " million/s", "32 paths per pixel", "wrote"}) {
        EXPECT_NE(result.out.find(text), std::string::npos) << text << "\n" << result.out;
    }
}

TEST_F(Reference, TwoRunsGiveTheSameBytes) {
    ASSERT_EQ(trace({"-o", file("a.exr"), "--spp", "16"}).code, 0);
    ASSERT_EQ(trace({"-o", file("b.exr"), "--spp", "16"}).code, 0);
    EXPECT_EQ(read_text(file("a.exr")), read_text(file("b.exr")));
}

TEST_F(Reference, OptionsOverrideTheSceneAndChooseLayers) {
    ASSERT_EQ(trace({"-o", file("a.exr"), "--spp", "4", "--resolution", "10x7", "-D", "depth=2", "--aov", "bounces,albedo"}).code, 0);
    std::string info = image_info(file("a.exr"));
    EXPECT_NE(info.find("10 x    7, 6 channel"), std::string::npos) << info;
    EXPECT_NE(info.find("pencil:maxDepth: 2"), std::string::npos) << info;
    ASSERT_EQ(trace({"-o", file("b.exr"), "--spp", "64", "-D", "depth=2", "--max-depth", "3", "--aov", "bounces"}).code, 0);
    info = image_info(file("b.exr"));
    EXPECT_NE(info.find("channel list: R, G, B, bounce2.R, bounce2.G, bounce2.B\n"), std::string::npos) << info;
    ASSERT_EQ(trace({"-o", file("d.exr"), "--spp", "1"}).code, 0);
    info = image_info(file("d.exr"));
    EXPECT_NE(info.find("position.X"), std::string::npos) << info;
    EXPECT_EQ(info.find("variance.R"), std::string::npos) << "only where it is asked for";
    ASSERT_EQ(trace({"-o", file("c.exr"), "--spp", "1", "--aov", "none"}).code, 0);
    EXPECT_NE(image_info(file("c.exr")).find("channel list: R, G, B\n"), std::string::npos);
}

TEST_F(Reference, TimeBudgetAndStatistics) {
    const RunResult result = trace({"-o", file("a.exr"), "--time", "0.2", "--stats", file("a.json")});
    ASSERT_EQ(result.code, 0) << result.err;
    const nlohmann::json stats = nlohmann::json::parse(read_text(file("a.json")));
    EXPECT_EQ(stats.at("schema"), 1);
    EXPECT_EQ(stats.at("options").at("time"), 0.2);
    EXPECT_TRUE(stats.at("options").at("spp").is_null());
    EXPECT_EQ(stats.at("paths"), stats.at("spp").get<int>() * 24 * 16);
    EXPECT_GT(stats.at("rays"), stats.at("paths"));
    EXPECT_GT(stats.at("paths_per_second"), 0.0);
    ASSERT_EQ(stats.at("stages").size(), 4U);
    double sum = 0;
    for (const nlohmann::json& stage : stats.at("stages")) sum += stage.at("wall_seconds").get<double>();
    EXPECT_LE(sum, 1.01 * stats.at("total_wall_seconds").get<double>()) << "stages do not overlap, on whatever clock";
    EXPECT_NE(image_info(file("a.exr")).find("pencil:traceSeconds"), std::string::npos);
}

TEST_F(Reference, AgreesWithRender) {
    ASSERT_EQ(trace({"-o", file("a.exr"), "--spp", "256", "--aov", "albedo,depth"}).code, 0);
    ASSERT_EQ(run_pencil({"render", scene, "-o", file("b.exr"), "--aov", "albedo,depth", "--film-samples", "64"}).code, 0);
    const auto mean_of = [&](const std::string& name) {
        const std::string info = image_info(file(name)), key = "Stats Avg: ";
        const std::size_t at = info.find(key);
        EXPECT_NE(at, std::string::npos) << info;
        std::vector<double> means;
        const char* text = info.c_str() + at + key.size();
        for (int c = 0; c < 7; ++c) {
            char* end = nullptr;
            means.push_back(std::strtod(text, &end));
            text = end;
        }
        return means;
    };
    const std::vector<double> traced = mean_of("a.exr"), rendered = mean_of("b.exr");
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(rendered[c] / traced[c], 1, 0.05) << "beauty " << c;
    for (std::size_t c = 3; c < 6; ++c) EXPECT_NEAR(rendered[c] / traced[c], 1, 0.01) << "albedo " << c - 3;
}

TEST_F(Reference, RefusesWhatRenderRefuses) {
    const auto refused = [&](const std::vector<std::string>& more, int code, const std::string& reason) {
        const RunResult result = trace(more);
        EXPECT_EQ(result.code, code) << result.err;
        EXPECT_NE(result.err.find(reason), std::string::npos) << result.err;
        EXPECT_TRUE(result.out.empty());
    };
    const std::string image = file("a.exr");
    refused({}, 2, "--output");
    refused({"-o", file("a.tiff")}, 2, ".exr or .png");
    refused({"-o", image, "--spp", "0"}, 2, "1 to 16777216");
    refused({"-o", image, "--time", "0"}, 2, "above 0");
    refused({"-o", image, "--time", "nan"}, 2, "above 0");
    refused({"-o", image, "--time", "1", "--spp", "1"}, 2, "--spp");
    refused({"-o", image, "--max-depth", "0"}, 2, "1 to 1000");
    refused({"-o", image, "--resolution", "0x0"}, 2, "WIDTHxHEIGHT");
    refused({"-o", image, "--aov", "colour"}, 2, "variance");
    refused({"-o", image, "--seed", "-1"}, 2, "18446744073709551615");
    refused({"-o", file("none/a.exr")}, 6, "does not exist");
    refused({"-o", image, "-o", image}, 6, "named twice");
    refused({"-o", image, "--stats", scene}, 6, "it is the scene");
    refused({"-o", image, "--resolution", "1000000x1000000"}, 5, "TiB");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"room.xml"});
    EXPECT_EQ(run_pencil({"reference", "/nonexistent/room.xml", "-o", image}).code, 3);
}

TEST_F(Reference, SceneWithoutLightIsBlackAndSaysSo) {
    const std::string dark = folder.write("dark.xml", small_scene(false));
    const RunResult result = run_pencil({"reference", dark, "-o", file("a.exr"), "--spp", "2", "--aov", "none", "--quiet"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.err, "pencil: warning: the scene has no light: the image is black\n");
    const std::string empty = folder.write("void.xml", small_scene(false, false));
    EXPECT_EQ(run_pencil({"reference", empty, "-o", file("b.exr"), "--spp", "2", "--quiet"}).code, 0);
}

class InterruptReference : public testing::TestWithParam<int> {};

TEST_P(InterruptReference, WritesThePartialResultWithStatus7) {
    const Folder folder;
    const std::string scene = folder.write("room.xml", small_scene());
    Child child({PENCIL_PROGRAM, "reference", scene, "-o", (folder / "a.exr").string(), "--spp", "16777216", "--aov", "none"});
    ASSERT_TRUE(child.wait_for_error_text("trace paths")) << "no progress line";
    child.send(GetParam());
    const RunResult result = child.wait();
    EXPECT_EQ(result.code, 7) << result.out << result.err;
    EXPECT_NE(result.err.find("interrupted"), std::string::npos) << result.err;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.exr", "room.xml"}));
    EXPECT_NE(image_info(folder / "a.exr").find("pencil:interrupted: 1"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Signals, InterruptReference, testing::Values(SIGINT, SIGTERM));

TEST_F(Reference, HelpNamesItsOptions) {
    const RunResult help = run_pencil({"reference", "--help"});
    EXPECT_EQ(help.code, 0);
    for (const char* word : {"--output", "--spp", "--time", "--max-depth", "--seed", "--resolution", "--aov", "--define", "--stats",
                             "--quiet", "Exit status"}) {
        EXPECT_NE(help.out.find(word), std::string::npos) << word;
    }
}

}  // namespace
}  // namespace pencil_test
