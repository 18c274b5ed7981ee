// A whole render from outside: layers and metadata of the files, repeatability, the statistics, and scenes with little in them.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {
namespace {

class Render : public testing::Test {
protected:
    RunResult render(const std::string& file_name, const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"render"};
        arguments.insert(arguments.end(), more.begin(), more.end());  // options before the scene
        arguments.push_back(file_name);
        arguments.insert(arguments.end(), quick().begin(), quick().end());
        return run_pencil(arguments);
    }
    std::string file(const std::string& name) const { return (folder / name).string(); }

    Folder folder;
    std::string scene = folder.write("room.xml", small_scene());
};

TEST_F(Render, HasAllLayersAndTellsHowItWasMade) {
    const RunResult result = render(scene, {"-o", file("a.exr"), "-o", file("a.png"), "--seed", "18446744073709551615"});
    ASSERT_EQ(result.code, 0) << result.err;
    const std::string info = image_info(file("a.exr"));
    for (const char* text :
         {"24 x   16", "float openexr", "R, G, B,", "emission.R", "direct.R, direct.G, direct.B", "bounce2.R", "albedo.G",
          "normal.X, normal.Y, normal.Z", "depth.Z", "position.X", "pencil:version", "pencil:scene: \"room.xml\"", "pencil:device",
          "pencil:driver", "pencil:pencils: 16", "pencil:seed: \"18446744073709551615\""}) {
        EXPECT_NE(info.find(text), std::string::npos) << text << "\n" << info;
    }
    EXPECT_EQ(info.find(folder.path().filename().string() + "\""), std::string::npos) << "the header holds no path";
    EXPECT_NE(image_info(file("a.png")).find("3 channel, uint8 png"), std::string::npos);
    for (const char* text : {"stage", "total", "device", "memory", "wrote"}) {
        EXPECT_NE(result.out.find(text), std::string::npos) << text << "\n" << result.out;
    }
}

TEST_F(Render, TwoRunsGiveTheSameBytesWhateverTheNames) {
    ASSERT_EQ(render(scene, {"-o", file("a.exr"), "-o", file("a.png")}).code, 0);
    std::filesystem::create_directory(folder / "other");
    ASSERT_EQ(render(scene, {"-o", file("other/second.exr"), "-o", file("other/second.png")}).code, 0);
    EXPECT_EQ(read_text(file("a.exr")), read_text(file("other/second.exr")));
    EXPECT_EQ(read_text(file("a.png")), read_text(file("other/second.png")));
}

TEST_F(Render, AovChoosesTheLayers) {
    ASSERT_EQ(render(scene, {"-o", file("none.exr"), "--aov", "none"}).code, 0);
    EXPECT_NE(image_info(file("none.exr")).find("channel list: R, G, B\n"), std::string::npos) << image_info(file("none.exr"));
    ASSERT_EQ(render(scene, {"-o", file("two.exr"), "--aov", "depth,albedo"}).code, 0);
    EXPECT_NE(image_info(file("two.exr")).find(" 7 channel"), std::string::npos) << image_info(file("two.exr"));
}

TEST_F(Render, OptionsOverrideTheScene) {
    ASSERT_EQ(render(scene, {"-o", file("a.exr"), "--resolution", "10x7", "-D", "depth=2"}).code, 0);
    const std::string info = image_info(file("a.exr"));
    EXPECT_NE(info.find("10 x    7"), std::string::npos) << info;
    EXPECT_NE(info.find("pencil:bounces: 1"), std::string::npos) << "max_depth 2 is one reflection\n" << info;
    EXPECT_EQ(info.find("bounce2"), std::string::npos) << info;
    ASSERT_EQ(render(scene, {"-o", file("b.exr"), "--bounces", "auto", "-D", "depth=2"}).code, 0);
    EXPECT_NE(image_info(file("b.exr")).find("pencil:bounces: \"auto\""), std::string::npos);
}

TEST_F(Render, QuietSaysNothingAndExplainSaysWhy) {
    const RunResult quiet = render(scene, {"-o", file("a.exr"), "--quiet"});
    EXPECT_EQ(quiet.code, 0);
    EXPECT_TRUE(quiet.out.empty()) << quiet.out;
    EXPECT_TRUE(quiet.err.empty()) << quiet.err;
    const RunResult explained = render(scene, {"-o", file("a.exr"), "--quiet", "--explain"});
    EXPECT_EQ(explained.code, 0);
    EXPECT_NE(explained.out.find("device: "), std::string::npos) << explained.out;
}

TEST_F(Render, StatisticsFollowTheirSchema) {
    ASSERT_EQ(render(scene, {"-o", file("a.exr"), "--stats", file("a.json")}).code, 0);
    const nlohmann::json stats = nlohmann::json::parse(read_text(file("a.json")));
    EXPECT_EQ(stats.at("schema"), 1);
    EXPECT_EQ(stats.at("options").at("pencils"), 16);
    EXPECT_EQ(stats.at("options").at("resolution"), nlohmann::json({24, 16}));
    for (const char* key : {"version", "scene", "driver"}) {
        EXPECT_TRUE(stats.at(key).is_string()) << key;
    }
    for (const char* key : {"kernel_build_seconds", "total_wall_seconds", "residual", "film_surfels", "blind_surfels", "peak_rss_bytes",
                            "device_peak_bytes", "triangles"}) {
        EXPECT_TRUE(stats.at(key).is_number()) << key;
    }
    for (const char* key : {"stages", "bounces", "explain", "warnings", "layers"}) {
        EXPECT_TRUE(stats.at(key).is_array()) << key;
    }
    ASSERT_FALSE(stats.at("stages").empty());
    double sum = 0;
    for (const nlohmann::json& stage : stats.at("stages")) {
        EXPECT_TRUE(stage.at("name").is_string() && stage.at("device_seconds").is_number() && stage.at("launches").is_number());
        sum += stage.at("wall_seconds").get<double>();
        int launches = 0;
        for (const nlohmann::json& kernel : stage.at("kernel_launches")) launches += kernel.at("launches").get<int>();
        EXPECT_EQ(launches, stage.at("launches")) << stage.at("name");
    }
    EXPECT_LE(sum, 1.01 * stats.at("total_wall_seconds").get<double>()) << "stages do not overlap, on whatever clock";
    EXPECT_FALSE(stats.at("kernel_launches").empty());
    EXPECT_TRUE(stats.at("tail_closed").is_boolean());
    EXPECT_NE(image_info(file("a.exr")).find("pencil:wallSeconds"), std::string::npos) << "times are in the header when asked for";
}

void expect_black(const std::string& image) {
    const std::string info = image_info(image);
    const std::size_t start = info.find("Stats Max: ");
    ASSERT_NE(start, std::string::npos) << info;
    EXPECT_EQ(info.compare(start, 26, "Stats Max: 0.000000 0.0000"), 0) << info.substr(start, 60);
}

TEST_F(Render, SceneWithoutLightIsBlackAndSaysSo) {
    const RunResult result = render(folder.write("dark.xml", small_scene(false)), {"-o", file("a.exr"), "--aov", "none", "--quiet"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.err.find("pencil: warning: "), std::string::npos) << result.err;
    expect_black(file("a.exr"));
}

TEST_F(Render, SceneWithoutGeometryIsBlackAndSaysSo) {
    const RunResult result = render(folder.write("void.xml", small_scene(false, false)), {"-o", file("a.exr"), "--aov", "none", "--quiet"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.err.find("pencil: warning: "), std::string::npos) << result.err;
    expect_black(file("a.exr"));
}

}  // namespace
}  // namespace pencil_test
