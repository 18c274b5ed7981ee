#include "measure/sensor_film.h"

#include "image/colour.h"
#include "scene/sensor_places.h"

namespace pencil {

Scene with_sensors(const Scene& scene, const std::vector<Sensor>& sensors) {
    Scene measured = scene;
    for (const Sensor& sensor : sensors) measured.sensor_points.push_back(sensor.place);
    measured.sensor = PerspectiveSensor();
    measured.sensor.to_world[3] = glm::dvec4(middle_of_sensors(measured), 1.0);
    return measured;
}

std::vector<double> pixel_luminances(const std::vector<float>& rgb, double factor) {
    std::vector<double> values;
    for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) values.push_back(factor * luminance({rgb[i], rgb[i + 1], rgb[i + 2]}));
    return values;
}

}  // namespace pencil
