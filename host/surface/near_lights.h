// Bright spots before which a light stands so close that rays in all directions do not find them: lamps on walls, bulbs in shades. A light looks
// about for them itself (small_lights.h).
#pragma once

#include <vector>

#include "surface/small_lights.h"
#include "surface/spots.h"

namespace pencil {

/// What a ray from a light meets.
struct LightHit {
    glm::vec3 position;  // [scene units]
    float distance;      // from the light [scene units], infinite: none
    double flux;         // that is reflected by the part of the surface which the ray stands for, rgb together [W]
};

/// Spheres about the place where a light is nearest to a surface, one within the other, as far as `reach` [scene units]; none where it is not
/// much nearer than that. weight: what each reflects outside of the next smaller one [W].
std::vector<Spot> near_light_spots(const std::vector<LightHit>& hits, float reach);

/// The spots of all lights from what their probes met, which sends `radiance` [3][capacity]; `power`: of all light [W]. Those that reflect next to
/// nothing of it are left out, and so are lights wider than `reach`; weight: share of what all reflect.
std::vector<Spot> near_light_spots(const std::vector<SmallLight>& lights, const Surfels& met, const Buffer<float>& radiance, float reach,
                                   double power);

}  // namespace pencil
