#include "scene/mitsuba/sun_and_sky.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/mitsuba/preetham.h"
#include "scene/mitsuba/sun_position.h"
#include "util/constants.h"

namespace pencil {
namespace {

constexpr int map_width = 512, map_height = 256;

/// Unit, in the emitter's frame: up to version 1, +y is the zenith, -z north and +x east; later +z is the zenith, +x south and +y west.
glm::dvec3 direction_by_time(Properties& p, int version) {
    PlaceAndTime at;
    at.latitude = p.number("latitude", at.latitude);
    at.longitude = p.number("longitude", at.longitude);
    at.timezone = p.number("timezone", at.timezone);
    const auto whole = [&](const char* name, int absent) { return static_cast<int>(std::clamp(p.number(name, absent), -9999.0, 9999.0)); };
    at.year = whole("year", at.year);
    at.month = std::clamp(whole("month", at.month), 1, 12);
    at.day = std::clamp(whole("day", at.day), 1, 31);
    at.hour = p.number("hour", at.hour) + p.number("minute", 0) / 60 + p.number("second", 0) / 3600;
    const SunPosition sun = sun_position(at);
    const double east = std::cos(sun.elevation) * std::sin(sun.azimuth), north = std::cos(sun.elevation) * std::cos(sun.azimuth);
    const double up = std::sin(sun.elevation);
    return version < 2 ? glm::dvec3(east, up, -north) : glm::dvec3(-north, -east, up);
}

Environment draw_sky(const PreethamSky& sky, const glm::vec3& scale) {
    Environment map;
    map.width = map_width;
    map.height = map_height;
    for (int row = 0; row < map_height; ++row) {
        const double theta = (row + 0.5) / map_height * pi;
        for (int column = 0; column < map_width; ++column) {
            const double phi = (column + 0.5) / map_width * 2 * pi;
            const glm::dvec3 direction(std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi));
            map.texels.push_back(direction.y > 0 ? glm::vec3(sky.radiance(direction)) : glm::vec3(0.0F));
        }
    }
    map.radiance = scale;
    return map;
}

}  // namespace

SunAndSky read_sun_and_sky(Properties& p, const std::string& type, int version) {
    // Columns: axes of a frame with +y up in the emitter's.
    const glm::dmat3 up = version < 2 ? glm::dmat3(1.0) : glm::dmat3(1, 0, 0, 0, 0, 1, 0, -1, 0);
    const bool given = p.has("sun_direction");
    const glm::dvec3 wanted = p.vector("sun_direction", glm::dvec3(0.0));
    if (given && !(glm::length(wanted) > 0)) p.fail("sun_direction", "sun_direction must not be zero");
    const glm::dvec3 to_sun = glm::transpose(up) * (given ? glm::normalize(wanted) : direction_by_time(p, version));
    const double turbidity = p.number("turbidity", 3);
    const auto scale = static_cast<float>(p.number("scale", 1));
    const float sky_scale = scale * static_cast<float>(p.number("sky_scale", 1)),
                sun_scale = scale * static_cast<float>(p.number("sun_scale", 1));
    p.approximate("", "is approximated: the sky by Preetham's model, the sun by parallel light");
    p.ignore({"albedo", "resolution", "stretch", "extend", "sun_radius_scale", "sun_aperture", "latitude", "longitude", "timezone", "year",
              "month", "day", "hour", "minute", "second", "complex_sun", "to_world"});
    SunAndSky result;
    if (to_sun.y <= 0) {
        p.source().warn(p.node(), p.label() + ": the sun is below the horizon, which gives no light");
        return result;
    }
    const PreethamSky sky(to_sun, std::clamp(turbidity, 1.7, 10.0));
    if (type != "sky") result.sun = {-(up * to_sun), glm::vec3(sky.sun_irradiance()) * sun_scale};
    if (type != "sun") {
        result.sky = draw_sky(sky, glm::vec3(sky_scale));
        result.sky->to_world = up;
    }
    return result;
}

}  // namespace pencil
