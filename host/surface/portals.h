// Portals: narrow places that much of the light comes through on its way to pencils, such as windows, doors and lamps that pencils see. Where spots
// are known by what they reflect, portals are known by the rays that meet there, wherever these end.
#pragma once

#include <vector>

#include "surface/seen_points.h"
#include "surface/spots.h"

namespace pencil {

/// A ray of a pencil, and what it has met.
struct LightRay {
    glm::vec3 origin, direction;  // [scene units], unit
    float distance;               // [scene units], INFINITY: nothing
    float light;                  // that it brings, in terms of the mean of its pencil's rays
    float emission;               // its share that is emitted there, not reflected
};

/// What pencils see: `points`, which `seen` are on the device; emission and light: what each sends, emitted and in all (light_of); `outgoing`:
/// surfels have directions (Features). Rays that lobes have turned are left out, and those of pencils that find their light well enough.
std::vector<LightRay> light_rays(const SeenPoints& points, const Surfels& seen, bool outgoing, const std::vector<float>& emission,
                                 const std::vector<float>& light);

/// Beside the spots that are known already. None if rays in all directions find the light well enough. `reach`: radius of the widest [scene units].
std::vector<Spot> find_portals(const std::vector<LightRay>& rays, float reach, const std::vector<Spot>& known = {});

}  // namespace pencil
