// Where the sun stands, by place and time.
#pragma once

namespace pencil {

struct PlaceAndTime {
    double latitude = 35.6894, longitude = 139.6917;  // [degrees] north, east
    double timezone = 9;                              // [hours] ahead of universal time
    int year = 2010, month = 7, day = 10;
    double hour = 15;  // with fractions, local time
};

struct SunPosition {
    double elevation, azimuth;  // [radians] above the horizon, from north over east
};

SunPosition sun_position(const PlaceAndTime& at);

}  // namespace pencil
