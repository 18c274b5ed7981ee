#include "measure/measurements_csv.h"

#include <fmt/format.h>

namespace pencil {

namespace {

/// RFC 4180: quoted where a comma, a quote or a line break stands in it.
std::string field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

std::string place_fields(const SensorPoint& place) {
    if (place.shape >= 0) return ",,,,,";
    const glm::dvec3 &p = place.position, &n = place.normal;
    return fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}", p.x, p.y, p.z, n.x, n.y, n.z);
}

}  // namespace

std::string measurements_csv(const std::vector<Sensor>& sensors, const Measurements& measurements) {
    std::string csv = "sensor,x,y,z,nx,ny,nz,illuminance,low,high,direct,indirect\n";
    for (std::size_t i = 0; i < sensors.size(); ++i) {
        const Illuminance& e = measurements.sensors.at(i);
        csv += fmt::format("{},{},{:.7g},{:.7g},{:.7g},{:.7g},{:.7g}\n", field(sensors[i].name), place_fields(sensors[i].place), e.value,
                           e.low, e.high, e.direct, e.indirect());
    }
    return csv;
}

}  // namespace pencil
