// Daylight: Mitsuba's emitters "sky", "sun" and "sunsky", approximated by the model of Preetham, Shirley and Smits.
#pragma once

#include <optional>
#include <string>

#include "scene/mitsuba/properties.h"
#include "scene/scene.h"

namespace pencil {

/// In the emitter's own frame.
struct SunAndSky {
    DirectionalLight sun{glm::dvec3(0, -1, 0), glm::vec3(0.0F)};
    std::optional<Environment> sky;  // its to_world turns the map's frame to the emitter's
};

/// `version`: the zenith is +y up to version 1, +z later.
SunAndSky read_sun_and_sky(Properties& p, const std::string& type, int version);

}  // namespace pencil
