// The emitters that check paths choose from, whatever form their light has in the method that is checked.
#pragma once

#include <vector>

#include "pencils/flat_scene.h"
#include "scene/scene.h"
#include "shared/emitter.h"

namespace pencil {

struct EmitterTable {
    std::vector<Emitter> emitters;  // triangles and point lights, chosen by power
    double power = 0;               // of all: luminance of radiance times area [scene units^2]
    double sky_area = 0;            // that the sky counts with, as do parallel lights with their irradiance [scene units^2]
};

/// A point light counts with the power that a small sphere of its intensity has.
EmitterTable tabulate_emitters(const Scene& scene, const FlatScene& flat);

}  // namespace pencil
