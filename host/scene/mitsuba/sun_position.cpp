// Low-precision formulae of the Astronomical Almanac: within 0.02 degrees between 1950 and 2050.
#include "scene/mitsuba/sun_position.h"

#include <algorithm>
#include <cmath>

#include "util/constants.h"

namespace pencil {
namespace {

constexpr double degree = pi / 180.0;

/// Days since the noon of 1 January 2000, universal time.
double days_since_2000(const PlaceAndTime& at) {
    const int a = (at.month - 14) / 12;
    const long julian = (1461L * (at.year + 4800 + a)) / 4 + (367L * (at.month - 2 - 12 * a)) / 12 -
                        (3L * ((at.year + 4900 + a) / 100)) / 4 + at.day - 32075;  // Fliegel and van Flandern 1968
    return static_cast<double>(julian) - 2451545.0 - 0.5 + (at.hour - at.timezone) / 24.0;
}

}  // namespace

SunPosition sun_position(const PlaceAndTime& at) {
    const double n = days_since_2000(at);
    const double mean = (280.460 + 0.9856474 * n) * degree, anomaly = (357.528 + 0.9856003 * n) * degree;
    const double ecliptic = mean + (1.915 * std::sin(anomaly) + 0.020 * std::sin(2 * anomaly)) * degree;
    const double obliquity = (23.439 - 0.0000004 * n) * degree;
    const double ascension = std::atan2(std::cos(obliquity) * std::sin(ecliptic), std::cos(ecliptic));
    const double declination = std::asin(std::sin(obliquity) * std::sin(ecliptic));
    const double sidereal_hours = 18.697374558 + 24.06570982441908 * n;
    const double hour_angle = std::remainder(sidereal_hours * 15.0 + at.longitude, 360.0) * degree - ascension;
    const double latitude = at.latitude * degree;
    const double up = std::sin(latitude) * std::sin(declination) + std::cos(latitude) * std::cos(declination) * std::cos(hour_angle);
    const double east = -std::cos(declination) * std::sin(hour_angle);
    const double north = std::cos(latitude) * std::sin(declination) - std::sin(latitude) * std::cos(declination) * std::cos(hour_angle);
    return {std::asin(std::clamp(up, -1.0, 1.0)), std::atan2(east, north)};
}

}  // namespace pencil
