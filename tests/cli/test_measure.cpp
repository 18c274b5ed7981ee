// `pencil measure` from outside: the table, and what is refused.
#include <gtest/gtest.h>

#include <sstream>

#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {
namespace {

/// Columns of a line without quotes.
std::vector<std::string> columns_of(const std::string& line) {
    std::vector<std::string> columns;
    std::istringstream stream(line);
    for (std::string column; std::getline(stream, column, ',');) columns.push_back(column);
    return columns;
}

/// A point light of 9 cd, 3 above a black floor that has a meter.
std::string lit_floor() {
    return "<scene version=\"3.0.0\">\n<shape type=\"rectangle\"><bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0\"/></bsdf>"
           "<sensor type=\"irradiancemeter\" id=\"floor\"/></shape>\n<emitter type=\"point\"><point name=\"position\" value=\"0, 0, 3\"/>"
           "<rgb name=\"intensity\" value=\"9\"/></emitter>\n</scene>\n";
}

TEST(Measure, WritesATableOfPointsGridsAndMeters) {
    const Folder folder;
    const std::string scene = folder.write("scene.xml", lit_floor()), points = folder.write("points.csv", "0,0,0,0,0,1\n");
    for (const std::string method : {"surface", "reference"}) {
        std::vector<std::string> command{"measure",  scene,  "--points",          points, "--grid", "-1,-1,1;2,0,0;0,2,0;1;1",
                                         "--method", method, "--lumens-per-watt", "100",  "--quiet"};
        if (method == "surface")
            command.insert(command.end(), {"--target-error", "1e-4"});
        else
            command.insert(command.end(), {"--time", "0.2"});
        const RunResult result = run_pencil(command);
        ASSERT_EQ(result.code, 0) << result.err;
        EXPECT_EQ(result.err, "");
        const std::vector<std::string> lines = lines_of(result.out);
        ASSERT_EQ(lines.size(), 4U) << result.out;
        EXPECT_EQ(lines[0], "sensor,x,y,z,nx,ny,nz,illuminance,low,high,direct,indirect");
        EXPECT_NEAR(std::stod(columns_of(lines[1]).at(7)), 100, 0.1) << lines[1];
        EXPECT_NEAR(std::stod(columns_of(lines[2]).at(7)), 225, 0.2) << lines[2];
        EXPECT_EQ(columns_of(lines[3]).at(0), "floor");
        EXPECT_NEAR(std::stod(columns_of(lines[3]).at(7)), 90.2, 2) << "mean over 2 x 2: " << lines[3];
    }
}

TEST(Measure, WritesAFileAndSaysSo) {
    const Folder folder;
    const std::string scene = folder.write("scene.xml", lit_floor()), table = folder / "table.csv";
    const RunResult result = run_pencil({"measure", scene, "-o", table, "--method", "reference", "--time", "0.1"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("table.csv"), std::string::npos) << result.err;
    EXPECT_EQ(lines_of(read_text(table)).size(), 2U);
    EXPECT_EQ(run_pencil({"measure", scene, "-o", scene}).code, 6);
    EXPECT_EQ(run_pencil({"measure", scene, "--points", table, "-o", table}).code, 6);
}

TEST(Measure, RefusesWhatMakesNoSense) {
    const Folder folder;
    const std::string scene = folder.write("scene.xml", small_scene()), bad = folder.write("bad.csv", "0,0,0,0,0,1\n1,2\n");
    const auto refused = [&](std::vector<std::string> more, int code, const std::string& message) {
        more.insert(more.begin(), {"measure", scene});
        const RunResult result = run_pencil(more);
        EXPECT_EQ(result.code, code) << result.err;
        EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
        EXPECT_EQ(result.out, "");
    };
    refused({}, 2, "there is nothing to measure");
    refused({"--points", bad}, 3, "bad.csv:2: 2 numbers");
    refused({"--points", folder / "absent.csv"}, 3, "absent.csv");
    refused({"--grid", "0,0,0;1,0,0;0,1,0"}, 2, "--grid");
    refused({"--method", "line"}, 2, "surface, reference");
    refused({"--time", "1", "--target-error", "1e-4"}, 2, "--time excludes --target-error");
    refused({"--method", "reference", "--target-error", "1e-4"}, 2, "--target-error");
    refused({"--lumens-per-watt", "0"}, 2, "above 0");
    refused({"--method", "reference", "--device", "bogus"}, 2, "--device: is not an option of --method reference");
    refused({"--bounces", "0"}, 2, "1 to 1000");
    refused({"--grid", "0,0,0;1,0,0;0,1,0;1000;1000", "--grid", "0,0,0;1,0,0;0,1,0;1;1"}, 2,
            "more than 1000000 sensors: give fewer --grid or --points");
}

/// A scene without a camera is as good as any: nothing is seen here. Where a picture is taken, it is not.
TEST(Measure, NeedsNoCamera) {
    const Folder folder;
    const std::string scene = folder.write("scene.xml", lit_floor());
    const RunResult measured = run_pencil({"measure", scene, "--strict", "--method", "reference", "--time", "0.05", "--quiet"});
    EXPECT_EQ(measured.code, 0) << measured.err;
    const RunResult rendered = run_pencil({"render", scene, "--strict", "-o", folder / "a.exr"});
    EXPECT_EQ(rendered.code, 3) << rendered.err;
    EXPECT_NE(rendered.err.find("the scene has no sensor"), std::string::npos) << rendered.err;
}

/// Light without end has no upper end either.
TEST(Measure, ReflectionsWithoutASumAreExitStatus8) {
    const RunResult result = run_pencil({"measure", PENCIL_SOURCE_DIR "/scenes/furnace.xml", "-D", "albedo=1", "--grid",
                                         "-0.1,-0.1,0;0.2,0,0;0,0.2,0;1;1", "--target-error", "1e-3", "--quiet"});
    EXPECT_EQ(result.code, 8) << result.err;
    EXPECT_NE(result.err.find("reflections have no sum"), std::string::npos) << result.err;
    const std::vector<std::string> lines = lines_of(result.out);
    ASSERT_EQ(lines.size(), 2U) << result.out;
    EXPECT_EQ(columns_of(lines[1]).at(9), "inf") << lines[1];
}

/// Lamps in lumens beside lamps in watts: one factor cannot be right for both.
TEST(Measure, MixedUnitsAreTold) {
    const Folder folder;
    folder.write("lamp.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 2 1 1 2 0 0 0\n1 1 1\n0 90\n0\n100 100\n");
    std::string text = lit_floor();
    const std::string lamp = "<emitter type=\"ies\"><string name=\"filename\" value=\"lamp.ies\"/>";
    const auto warning_of = [&](const std::string& lamps, const std::vector<std::string>& more) {
        std::string all = text;
        const std::string scene = folder.write("scene.xml", all.insert(all.find("<emitter"), lamps));
        std::vector<std::string> command{"measure", scene, "--method", "reference", "--time", "0.02", "--quiet"};
        command.insert(command.end(), more.begin(), more.end());
        const RunResult result = run_pencil(command);
        EXPECT_EQ(result.code, 0) << result.err;
        return result.err;
    };
    const std::string told = warning_of(lamp + "</emitter>", {});
    for (const char* part : {"1 of 2 lights", "683", "179", "--lumens-per-watt"}) EXPECT_NE(told.find(part), std::string::npos) << told;
    EXPECT_EQ(warning_of(lamp + "</emitter>", {"--lumens-per-watt", "683"}), "");
    EXPECT_EQ(warning_of(lamp + "<rgb name=\"intensity\" value=\"1\"/></emitter>", {}), "") << "all in watts";
}

TEST(Measure, LayersInFalseColours) {
    const Folder folder;
    const std::string scene = folder.write("scene.xml", small_scene()), image = folder / "room.illuminance.png", exr = folder / "room.exr";
    const RunResult result = run_pencil({"render", scene, "-o", image, "-o", exr, "--quiet", "--target-error", "1", "--film-samples", "4"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_NE(image_info(exr).find("illuminance.Y"), std::string::npos) << image_info(exr);
    EXPECT_EQ(image_info(exr).find(", luminance.Y"), std::string::npos) << "not asked for";
    EXPECT_NE(image_info(image).find("3 channel"), std::string::npos) << image_info(image);
}

TEST(Measure, LayersThatMustBeNamed) {
    const Folder folder;
    const std::string scene = folder.write("scene.xml", small_scene()), exr = folder / "a.illuminance.exr";
    const auto traced = [&](const std::string& aovs, const std::string& image) {
        const RunResult result = run_pencil({"reference", scene, "-o", image, "--spp", "2", "--aov", aovs, "--quiet"});
        EXPECT_EQ(result.code, 0) << result.err;
        return result.err;
    };
    EXPECT_NE(traced("all", exr).find("a.illuminance.exr has no layer illuminance: --aov illuminance makes it"), std::string::npos);
    EXPECT_EQ(traced("all,illuminance", exr), "");
    const std::string info = image_info(exr);
    EXPECT_NE(info.find("illuminance.Y"), std::string::npos) << info;
    EXPECT_NE(info.find("albedo.R"), std::string::npos) << info;
    EXPECT_EQ(info.find(", luminance.Y"), std::string::npos) << info;
    EXPECT_NE(info.find("pencil:lumensPerWatt: 179"), std::string::npos) << info;
    const std::string shouted = folder / "a.ILLUMINANCE.png";
    EXPECT_EQ(traced("none", shouted), "");
    EXPECT_EQ(image_info(shouted).find("24 x   16"), std::string::npos) << "with a legend beside it";
}

}  // namespace
}  // namespace pencil_test
