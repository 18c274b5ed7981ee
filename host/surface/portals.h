// Portals: narrow places that much of the light comes through on its way to pencils, such as windows, doors and lamps that pencils see. Where spots
// are known by what they reflect, portals are known by the rays that meet there, wherever these end.
#pragma once

#include <vector>

#include "surface/seen_points.h"
#include "surface/spots.h"

namespace pencil {

/// A ray of a pencil, and what it has met.
struct LightRay {
    glm::vec3 origin, direction, normal;  // of its pencil [scene units]; unit; of its pencil, unit
    float distance;                       // [scene units], INFINITY: nothing
    float light;                          // that it brings
    float emission;                       // its share that is emitted there, not reflected
    bool turned = false;                  // by lobes, so that nothing is known of where it went
};

/// One for each texel of pencils that see `points`, which `seen` are on the device; emission and light: what each sends, emitted and in all
/// (light_of); `outgoing`: surfels have directions (Features).
std::vector<LightRay> light_rays(const SeenPoints& points, const Surfels& seen, bool outgoing, const std::vector<float>& emission,
                                 const std::vector<float>& light);

/// Lengths [scene units].
struct PortalLengths {
    float near;    // pencils that lie so close together receive about the same light
    float widest;  // radius of a portal
};

/// Beside the spots that are known already. `rays`: so many of each pencil, one pencil after the other, nothing else. None if rays in all
/// directions find the light well enough.
std::vector<Spot> find_portals(const std::vector<LightRay>& rays, int of_each, const PortalLengths& lengths,
                               const std::vector<Spot>& known = {});

}  // namespace pencil
