// Preetham, Shirley, Smits, A Practical Analytic Model for Daylight, SIGGRAPH 1999.
#pragma once

#include <glm/vec3.hpp>

namespace pencil {

class PreethamSky {
public:
    /// `to_sun`: unit, +y is the zenith. Turbidity from 1.7 (clear) to 10 (haze).
    PreethamSky(const glm::dvec3& to_sun, double turbidity);

    /// Radiance from `direction` (unit, above the horizon) as linear sRGB [W m^-2 sr^-1 nm^-1, mean over what the eye sees].
    glm::dvec3 radiance(const glm::dvec3& direction) const;
    /// Irradiance by the sun's disc of a surface across its light, in the same unit times steradian.
    glm::dvec3 sun_irradiance() const;

private:
    glm::dvec3 to_sun_;
    double turbidity_;
    glm::dvec3 zenith_;           // x, y (chromaticity), Y [kcd m^-2]
    glm::dvec3 coefficients_[5];  // of Perez' function, for x, y, Y
    glm::dvec3 perez_of_sun_;
};

}  // namespace pencil
