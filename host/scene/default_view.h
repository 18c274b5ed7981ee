// What a file of shapes alone lacks to be seen: a camera and light.
#pragma once

#include "scene/scene.h"

namespace pencil {

/// Sets the sensor so that it sees all triangles, from the right, the front (+z) and above (+y). The scene has triangles.
void frame_scene(Scene& scene);

/// True if anything in the scene emits.
bool has_light(const Scene& scene);

/// A clear sky: bluish from above, white at the horizon, brownish from below, about 1 everywhere [W m^-2 sr^-1].
Environment default_sky();

/// Does both where they are missing, and says so in the scene's warnings, which begin with `where`.
void complete_scene(Scene& scene, bool has_sensor, const std::string& where);

}  // namespace pencil
