#include "measure/sensor_film.h"

#include "scene/sensor_places.h"

namespace pencil {

Scene with_sensors(const Scene& scene, const std::vector<Sensor>& sensors) {
    Scene measured = scene;
    for (const Sensor& sensor : sensors) measured.sensor_points.push_back(sensor.place);
    measured.sensor = PerspectiveSensor();
    measured.sensor.to_world[3] = glm::dvec4(middle_of_sensors(measured), 1.0);
    return measured;
}

}  // namespace pencil
