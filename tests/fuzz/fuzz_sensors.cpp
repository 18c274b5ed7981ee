// Any bytes as a list of sensors: an error that names the line, or points and directions that are numbers.
#include <cstddef>
#include <cstdint>
#include <string>

#include "fuzz/scene_folder.h"
#include "measure/sensors.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const pencil::fuzz::SceneFolder folder;
    pencil::fuzz::write_file(folder.path / "points.csv", std::string(reinterpret_cast<const char*>(data), size));
    pencil::fuzz::accept_scene_errors([&] {
        for (const pencil::SensorPoint& point : pencil::read_sensor_points(folder.path / "points.csv"))
            pencil::fuzz::require(pencil::fuzz::is_finite(point.position) && pencil::fuzz::is_finite(point.normal));
    });
    return 0;
}
