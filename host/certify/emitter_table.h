// The emitters that check paths choose from, whatever form their light has in the method that is checked.
#pragma once

#include <vector>

#include "pencils/flat_scene.h"
#include "scene/scene.h"
#include "shared/emitter.h"

namespace pencil {

struct EmitterTable {
    std::vector<Emitter> emitters;  // triangles, point lights, parallel lights and texels of the sky, chosen mostly by power
    std::vector<float> densities;   // by material: of chosen points of triangles [1/scene units^2]
    double sky_density = 0;         // of chosen directions of the sky, for each unit of luminance above its limit [m^2 W^-1]
};

/// A point light counts with the power that a small sphere of its intensity has.
EmitterTable tabulate_emitters(const Scene& scene, const FlatScene& flat);

}  // namespace pencil
