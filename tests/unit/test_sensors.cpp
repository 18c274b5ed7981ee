// Sensors from text: points, grids, the meters of a scene; and the table of what they measure.
#include <stdexcept>

#include "measure/measurements_csv.h"
#include "measure/sensors.h"
#include "unit/scene_fixture.h"

namespace pencil::test {
namespace {

class Sensors : public SceneTest {
protected:
    std::vector<SensorPoint> points(const std::string& text) const { return read_sensor_points(write("points.csv", text)); }

    /// The message of the error, "" if there is none.
    std::string defect(const std::string& text) const {
        try {
            points(text);
        } catch (const SceneError& error) {
            return error.what();
        }
        return "";
    }
};

std::string grid_defect(const std::string& text) {
    try {
        parse_grid(text);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST_F(Sensors, PointsByCommasOrBlanksWithCommentsAndNames) {
    const std::vector<SensorPoint> found = points("# a desk\nx,y,z,nx,ny,nz\n1,2,3,0,0,2\n\n  4 5 6\t0 -1 0   # the wall\r\n7,8,9, 1,0,0");
    ASSERT_EQ(found.size(), 3U);
    expect_near(found[0].position, {1, 2, 3}, 0);
    expect_near(found[0].normal, {0, 0, 1}, 0);
    expect_near(found[1].position, {4, 5, 6}, 0);
    expect_near(found[1].normal, {0, -1, 0}, 0);
    expect_near(found[2].normal, {1, 0, 0}, 0);
}

TEST_F(Sensors, AGridIsTheMiddlesOfItsCells) {
    const SensorGrid grid = parse_grid("1,2,0.8;4,0,0;0,3,0;2;3");
    EXPECT_EQ(grid.columns, 2);
    EXPECT_EQ(grid.rows, 3);
    const std::vector<SensorPoint> found = grid_points(grid);
    ASSERT_EQ(found.size(), 6U);
    expect_near(found[0].position, {2, 2.5, 0.8}, 1e-15);
    expect_near(found[1].position, {4, 2.5, 0.8}, 1e-15);
    expect_near(found[5].position, {4, 4.5, 0.8}, 1e-15);
    for (const SensorPoint& point : found) expect_near(point.normal, {0, 0, 1}, 0);
    const std::vector<SensorPoint> of_file = points("grid 1,2,0.8, 4,0,0, 0,3,0, 2,3\n0,0,0,0,0,1\n");
    ASSERT_EQ(of_file.size(), 7U);
    for (std::size_t i = 0; i < 6; ++i) expect_near(of_file[i].position, found[i].position, 0);
}

TEST_F(Sensors, DefectsNameTheLineAndWhatIsExpected) {
    const auto says = [](const std::string& message, const std::string& part) {
        return message.find(part) != std::string::npos ? testing::AssertionSuccess() : testing::AssertionFailure() << message;
    };
    EXPECT_TRUE(says(defect("1,2,3,0,0,1\n1,2,3\n"), "points.csv:2: 3 numbers where 6 are expected: x,y,z,nx,ny,nz"));
    EXPECT_TRUE(says(defect("x y z nx ny nz\n1,2,three,0,0,1\n"), "points.csv:2: \"three\""));
    EXPECT_TRUE(says(defect("1,2,3,0,0,0\n"), "points.csv:1: the normal"));
    EXPECT_TRUE(says(defect("1,2,nan,0,0,1\n"), "points.csv:1:"));
    EXPECT_TRUE(says(defect("1,2,1e300,0,0,1\n"), "beyond 1e18"));
    EXPECT_TRUE(says(defect("# nothing\n"), "holds no point"));
    EXPECT_TRUE(says(defect("grid 0,0,0,1,0,0,2,0,0,3,3\n"), "must span a plane"));
    EXPECT_TRUE(says(defect("grid 0,0,0,1,0,0,0,1,0,3,2.5\n"), "columns and rows, not 2.5"));
    EXPECT_TRUE(says(defect("grid 0,0,0,1,0,0,0,1,0,9999,9999\n"), "more than 1000000 points"));
    EXPECT_THROW(read_sensor_points(folder_ / "absent.csv"), SceneError);
    EXPECT_TRUE(says(grid_defect("0,0,0;1,0,0;0,1,0;3"), "is not origin;u;v;columns;rows"));
    EXPECT_TRUE(says(grid_defect("0,0,0;1,0,0;0,1,0;0;3"), "1 to 1000000"));
    EXPECT_TRUE(says(grid_defect("0,0;1,0,0;0,1,0;3;3"), "is not origin;u;v;columns;rows"));
    EXPECT_TRUE(says(grid_defect("0,0;0,1,0,0;0,1,0;1;1"), "is not origin;u;v;columns;rows")) << "as many numbers, but not in their parts";
    EXPECT_TRUE(says(grid_defect("0,,0;1,0,0;0,1,0;3;3"), "a field between commas is empty"));
}

TEST_F(Sensors, NothingIsTakenForWhatItIsNot) {
    EXPECT_NE(defect("1,2,,0,0,1,5\n").find("points.csv:1: \"1,2,,0,0,1,5\": a field between commas is empty"), std::string::npos);
    EXPECT_NE(defect("1,2,3,0,0,1,\n"), "");
    EXPECT_NE(defect("0;0;1;0;0;1\n1,2,3,0,0,1\n"), "") << "no names of columns";
    EXPECT_NE(defect("x,y,z\n1,2,3,0,0,1\n"), "") << "too few names";
    EXPECT_NE(defect("1,2,3,0,0,1\nx,y,z,nx,ny,nz\n"), "") << "names after numbers";
    EXPECT_EQ(points("\xEF\xBB\xBF"
                     "1,2,3,0,0,1\n")
                  .size(),
              1U)
        << "a mark of UTF-8, as spreadsheets write it";
    EXPECT_EQ(points("\xEF\xBB\xBFx,y,z,nx,ny,nz\n1,2,3,0,0,1\n").size(), 1U);
}

LoadOptions without_camera() {
    LoadOptions options;
    options.camera = false;
    options.strict = true;
    return options;
}

/// A scene with a meter has no camera: that matters where pictures are taken.
TEST_F(Sensors, ACameraIsMissedByWhoNeedsIt) {
    const std::string text =
        "<scene version=\"3.0.0\"><shape type=\"rectangle\"><sensor type=\"irradiancemeter\" id=\"a\"/></shape></scene>";
    const Scene scene = load_text(text);
    ASSERT_EQ(scene.warnings.size(), 1U);
    EXPECT_NE(scene.warnings.front().find("the scene has no sensor"), std::string::npos) << scene.warnings.front();
    EXPECT_TRUE(load_text(text, without_camera()).warnings.empty());
}

TEST_F(Sensors, MetersOfAScene) {
    const Scene scene = load_text(
        "<scene version=\"3.0.0\">\n<shape type=\"rectangle\"/>\n<shape type=\"rectangle\" id=\"desk\">"
        "<sensor type=\"irradiancemeter\" id=\"on, the desk\"><film type=\"hdrfilm\"/></sensor></shape>\n"
        "<shape type=\"cube\"><sensor type=\"irradiancemeter\"/></shape>\n"
        "<shape type=\"cube\"><sensor type=\"irradiancemeter\" id=\"1\"/></shape>\n</scene>",
        without_camera());
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
    const std::vector<Sensor> sensors = all_sensors(points("1,2,3,0,0,1\n"), scene);
    ASSERT_EQ(sensors.size(), 4U);
    EXPECT_EQ(sensors[0].name, "1");
    EXPECT_EQ(sensors[1].name, "on, the desk");
    EXPECT_EQ(sensors[1].place.shape, 1);
    EXPECT_EQ(sensors[2].name, "cube 1");
    EXPECT_EQ(sensors[2].place.shape, 2);
    EXPECT_EQ(sensors[3].name, "meter 1") << "not that of the first point";
    expect_approximation("<shape type=\"rectangle\"><sensor type=\"radiancemeter\"/></shape>\n", 3, "inside a shape is not supported");
}

TEST_F(Sensors, ATableOfWhatWasMeasured) {
    std::vector<Sensor> sensors{{"1", {}}, {"on, the \"desk\"", {}}};
    sensors[0].place.position = {0.5, -2, 3};
    sensors[1].place.shape = 4;
    Measurements found;
    found.sensors = {{100, 99, 101, 60}, {7.5, 0, 20, 0}};
    EXPECT_EQ(measurements_csv(sensors, found),
              "sensor,x,y,z,nx,ny,nz,illuminance,low,high,direct,indirect\n"
              "1,0.5,-2,3,0,0,1,100,99,101,60,40\n"
              "\"on, the \"\"desk\"\"\",,,,,,,7.5,0,20,0,7.5\n");
}

/// Names come from scenes that nobody has checked.
TEST_F(Sensors, ATableHoldsNoFormulas) {
    Measurements found;
    found.sensors = {{1, 1, 1, 1}};
    const auto name_in_table = [&](const std::string& name) {
        Sensor meter{name, {}};
        meter.place.shape = 0;
        const std::string csv = measurements_csv({meter}, found);
        const std::size_t begin = csv.find('\n') + 1;
        return csv.substr(begin, csv.find(",,,,,,") - begin);
    };
    EXPECT_EQ(name_in_table("=cmd()"), "'=cmd()");
    for (const char* name : {"+1", "-1", "@a"}) EXPECT_EQ(name_in_table(name), "'" + std::string(name));
    EXPECT_EQ(name_in_table("=a,\"b\""), "\"'=a,\"\"b\"\"\"");
    EXPECT_EQ(name_in_table("desk\x1b[2J\n"), "desk\\x1b[2J\\x0a");
    EXPECT_EQ(name_in_table("desk"), "desk");
}

}  // namespace
}  // namespace pencil::test
