#include "measure/measurements_csv.h"

#include <fmt/format.h>

#include <string_view>

#include "scene/text.h"
#include "util/format.h"

namespace pencil {

namespace {

/// Names come from scene files: no control characters, nothing that a spreadsheet would take for a formula, and quotes where they are needed.
std::string field(const std::string& text) {
    std::string safe = escaped(text);
    if (!safe.empty() && std::string_view("=+-@").find(safe.front()) != std::string_view::npos) safe.insert(0, 1, '\'');
    return safe.find_first_of(",\"") == std::string::npos ? safe : csv_quoted(safe);
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
