// `pencil measure` from outside: the table, and what is refused.
#include <gtest/gtest.h>

#include <sstream>

#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

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
        const RunResult result = run_pencil({"measure", scene, "--points", points, "--grid", "-1,-1,1;2,0,0;0,2,0;1;1", "--method", method,
                                             "--time", "0.2", "--lumens-per-watt", "100", "--quiet"});
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
}

TEST(Measure, LayersInFalseColours) {
    const Folder folder;
    const std::string scene = folder.write("scene.xml", small_scene()), image = folder / "room.illuminance.png", exr = folder / "room.exr";
    std::vector<std::string> command{"render", scene, "-o", image, "-o", exr, "--quiet"};
    command.insert(command.end(), quick().begin(), quick().end());
    const RunResult result = run_pencil(command);
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_NE(image_info(exr).find("illuminance.Y"), std::string::npos) << image_info(exr);
    EXPECT_EQ(image_info(exr).find(", luminance.Y"), std::string::npos) << "not asked for";
    EXPECT_NE(image_info(image).find("3 channel"), std::string::npos) << image_info(image);
}

}  // namespace
}  // namespace pencil_test
