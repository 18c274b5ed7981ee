// Illuminance at sensors against closed forms, by the surface method and by the path tracer, and what the intervals say.
#include <cmath>

#include "measure/measure.h"
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"
#include "util/error.h"

namespace {

using namespace pencil;
using namespace pencil::test;

Sensor sensor(const dvec3& position, const dvec3& normal) {
    Sensor made;
    made.place.position = position;
    made.place.normal = normal;
    return made;
}

/// Of as few passes as may be, three.
constexpr double loose = 1;

/// Until an error is met, not until a time is over: the same on a machine however slow.
Measurements by_pencils(const Scene& scene, const std::vector<Sensor>& sensors, double target_error, std::uint64_t seed = 0) {
    RenderOptions options;
    options.lumens_per_watt = 1;
    options.target_error = target_error;
    options.seed = seed;
    return measure(scene, sensors, options, device());
}

Measurements by_paths(const Scene& scene, const std::vector<Sensor>& sensors, int spp) {
    ReferenceOptions options;
    options.spp = spp;
    return measure_by_paths(scene, sensors, options, 1);
}

void expect_relative(double value, double expected, double tolerance, const std::string& what) {
    EXPECT_NEAR(value, expected, tolerance * expected) << what;
}

/// Sensors lie a little before their points: what that changes where a lamp is near.
constexpr double before_surface = 5e-4;

/// A floor that something shines on, and sensors on it and above it: they hide nothing from each other.
TEST(Measure, PointLight) {
    Scene scene;
    add_quad(scene, "floor", {-4, 0, -4}, {0, 0, 8}, {8, 0, 0}, {glm::vec3(0.0F), glm::vec3(0.0F), false});
    scene.point_lights.push_back({{0, 3, 0}, glm::vec3(1000.0F)});
    const std::vector<dvec3> places{{0, 0, 0}, {0, 1, 0}, {1.5, 0, 0}, {1, 0, -1}, {0, 2.9, 0}};
    std::vector<Sensor> sensors;
    for (const dvec3& place : places) sensors.push_back(sensor(place, {0, 1, 0}));
    sensors.push_back(sensor({0, 1, 0}, {0, -1, 0}));
    const Measurements pencils = by_pencils(scene, sensors, loose), paths = by_paths(scene, sensors, 4);
    for (const Measurements* found : {&pencils, &paths}) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            const dvec3 way = dvec3(0, 3, 0) - places[i];
            const double expected = 1000 * way.y / std::pow(glm::length(way), 3);
            expect_relative(found->sensors[i].value, expected, before_surface, "sensor " + std::to_string(i));
            expect_relative(found->sensors[i].direct, expected, before_surface, "sensor " + std::to_string(i));
        }
        EXPECT_EQ(found->sensors.back().value, 0) << "it looks away";
    }
}

TEST(Measure, PolygonsByLambertsFormula) {
    for (const Luminaire& luminaire : luminaires()) {
        const Scene scene = luminaire_scene(luminaire);
        const std::vector<Sensor> sensors{sensor({0, 0, 0}, {0, 1, 0}), sensor({0.1, 0.05, 0.2}, {0, 1, 0})};
        const Measurements both = by_pencils(scene, sensors, 1e-3), paths = by_paths(scene, sensors, 4096);
        for (std::size_t i = 0; i < sensors.size(); ++i) {
            const double expected = ref::polygon_irradiance(luminaire.corners, sensors[i].place.position, {0, 1, 0});
            const Measurements alone = by_pencils(scene, {sensors[i]}, loose);
            expect_relative(alone.sensors.front().direct, expected, 0.003, luminaire.name);
            expect_relative(both.sensors[i].direct, expected, 0.003, luminaire.name);
            expect_relative(paths.sensors[i].direct, expected, 0.02, luminaire.name);
        }
    }
}

TEST(Measure, Furnace) {
    const std::vector<Sensor> sensors{sensor({0.3, 0.2, -0.1}, {0, 1, 0}), sensor({-1, 0.5, 0.5}, {1, 0, 0}),
                                      sensor({0, 0.99, 0}, {0.6, -0.8, 0})};
    for (const float albedo : {0.0F, 0.5F, 0.8F}) {
        const double expected = ref::pi / (1.0 - static_cast<double>(albedo));
        const Measurements pencils = by_pencils(furnace(albedo), sensors, loose), paths = by_paths(furnace(albedo), sensors, 4096);
        for (std::size_t i = 0; i < sensors.size(); ++i) {
            expect_relative(pencils.sensors[i].value, expected, 0.003, "pencils");
            expect_relative(pencils.sensors[i].direct, ref::pi, 0.003, "pencils, direct");
            expect_relative(paths.sensors[i].value, expected, 0.02, "paths");
            expect_relative(paths.sensors[i].direct, ref::pi, 0.02, "paths, direct");
        }
    }
}

/// A meter is the mean over its shape: energy balance of CIE 171:2006, test 5.8.
TEST(Measure, MetersOfTheCube) {
    for (const double albedo : {0.5, 0.9}) {
        const Scene scene = cie_cube(albedo);
        std::vector<Sensor> walls(6);
        for (std::size_t wall = 0; wall < 6; ++wall) walls[wall].place.shape = static_cast<std::int64_t>(wall);
        const Measurements pencils = by_pencils(scene, walls, loose);
        double mean = 0;
        for (const Illuminance& wall : pencils.sensors) mean += wall.value / 6;
        std::printf("albedo %.2f: %.4f of the energy balance\n", albedo, mean / cie_cube_answer(albedo));
        expect_relative(mean, cie_cube_answer(albedo), 0.005, "albedo " + std::to_string(albedo));
    }
}

/// The strongest lamp is in another room: it must not take all samples, paths and draws.
TEST(Measure, AStrongLampNextDoorTakesNothing) {
    Scene scene = cie_cube(0.5);
    add_box(scene, {10, 0, 0}, {14, 4, 4}, {glm::vec3(0.5F), glm::vec3(0.0F), false});
    scene.point_lights.push_back(scene.point_lights.front());
    scene.point_lights.back().position.x += 10;
    scene.point_lights.back().intensity *= 1e9F;
    std::vector<Sensor> walls(6);
    for (std::size_t wall = 0; wall < 6; ++wall) walls[wall].place.shape = static_cast<std::int64_t>(wall);
    const Measurements pencils = by_pencils(scene, walls, 3e-4), paths = by_paths(scene, walls, 4096);
    for (const Measurements* found : {&pencils, &paths}) {
        double mean = 0;
        for (const Illuminance& wall : found->sensors) mean += wall.value / 6;
        expect_relative(mean, cie_cube_answer(0.5), 0.01, found == &pencils ? "pencils" : "paths");
    }
}

/// What one pass or one path says of a meter says nothing of its error.
TEST(Measure, LittleKnowledgeHasNoUpperEnd) {
    Scene scene = cie_cube(0.5);
    std::vector<Sensor> sensors(1, sensor({1, 1, 1}, {0, 1, 0}));
    sensors.push_back({"wall", {}});
    sensors.back().place.shape = 0;
    RenderOptions short_time;
    short_time.seconds = 1e-6;
    const Measurements pencils = measure(scene, sensors, short_time, device());
    ASSERT_EQ(pencils.passes, 1);
    EXPECT_TRUE(std::isfinite(pencils.sensors[0].high)) << "light paths know the error of a point";
    EXPECT_TRUE(std::isinf(pencils.sensors[1].high));
    const Measurements paths = by_paths(scene, sensors, 1);
    for (const Illuminance& found : paths.sensors) EXPECT_TRUE(std::isinf(found.high));
    ASSERT_FALSE(paths.warnings.empty());
    EXPECT_NE(paths.warnings.back().find("give more --time"), std::string::npos) << paths.warnings.back();
}

/// Direct and all light are measured at the same places: what both share is not in their difference.
TEST(Measure, TheSplitIsSharperThanItsParts) {
    Scene scene = cie_cube(0.0);
    std::vector<Sensor> wall(1);
    wall[0].place.shape = 0;
    const Illuminance found = by_pencils(scene, wall, loose).sensors.front();
    EXPECT_NEAR(found.indirect(), 0, 1e-5 * found.value) << "black walls send nothing back";
}

/// Sensors do not help each other across what light does not pass: one room is lit, the other is not.
TEST(Measure, NothingLeaksFromSensorToSensor) {
    const Scene scene = two_rooms(0.0, true);
    const std::vector<Sensor> sensors{sensor({0.98, 0.5, 0.5}, {0, 1, 0}), sensor({1.02, 0.5, 0.5}, {0, 1, 0})};
    const Measurements found = by_pencils(scene, sensors, loose);
    std::printf("lit %.4g, dark %.4g\n", found.sensors[0].value, found.sensors[1].value);
    EXPECT_GT(found.sensors[0].value, 0.1);
    EXPECT_LE(found.sensors[1].value, 1e-3 * found.sensors[0].value);
    EXPECT_EQ(found.sensors[1].direct, 0);
}

/// How many intervals hold the mean of the path tracer, and whether each says something.
std::size_t count_held(const Measurements& found, const Measurements& truth) {
    std::size_t held = 0;
    for (std::size_t i = 0; i < found.sensors.size(); ++i) {
        const Illuminance& e = found.sensors[i];
        const double expected = truth.sensors[i].value;
        EXPECT_LT(e.high - e.low, 0.3 * e.value) << "an interval that says nothing, sensor " << i;
        held += e.low <= expected && expected <= e.high ? 1 : 0;
    }
    return held;
}

/// Where nothing is known in closed form, the intervals hold the path tracer's mean nearly always.
TEST(Measure, IntervalsHoldTheTruth) {
    const Scene scene = room_of_everything();
    std::vector<Sensor> sensors;
    for (int i = 0; i < 6; ++i)
        sensors.push_back(sensor({-0.7 + 0.25 * i, -0.6 + 0.2 * i, 0.5 - 0.15 * i}, glm::normalize(dvec3(0.2 * i, 1, -0.1 * i))));
    const Measurements truth = by_paths(scene, sensors, 1 << 16);
    std::size_t held = 0;
    constexpr std::uint64_t seeds = 8;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) held += count_held(by_pencils(scene, sensors, loose, seed), truth);
    EXPECT_GE(held, seeds * sensors.size() * 90 / 100);
}

TEST(Measure, TheLineMethodIsRefused) {
    Scene scene = furnace(0.5F);
    scene.sensor_points.push_back(sensor({0, 0, 0}, {0, 1, 0}).place);
    EXPECT_THROW(render(scene, line_options(), device()), UsageError);
}

}  // namespace
