// Bright spots: places that reflect much of the light and that few of the directions in which pencils look meet, such as the ceiling above a
// lamp that shines up, or what the sun lights through a window. Film pencils send some rays of their own to them.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <tuple>
#include <vector>

#include "cl/buffer.h"
#include "device/surfels.h"
#include "shared/spot.h"

namespace pencil {

struct Spot {
    glm::vec3 centre;    // [scene units]
    float radius;        // [scene units]
    float weight;        // its share of all that is reflected, about
    float emission = 0;  // the share of that which is emitted instead, where it is a portal (portals.h)
};

/// The place lies in the spot.
inline bool holds(const Spot& spot, const glm::vec3& place) { return glm::distance(spot.centre, place) < spot.radius; }

/// At most SPOTS_MOST of them, none if rays in all directions find the light well enough. `points` were met by such rays, each sends so much
/// `light`; those closer together than `reach` [scene units] may be one spot.
std::vector<Spot> find_spots(const std::vector<glm::vec3>& points, const std::vector<float>& light, float reach);

/// The spots in device memory, SPOTS_MOST of them at most, those that reflect most.
struct DeviceSpots {
    DeviceSpots() = default;
    DeviceSpots(const std::shared_ptr<Device>& device, const std::vector<Spot>& spots);
    /// Arguments `spots, weights, spot_count` of kernels.
    auto list() const { return std::tuple<const Buffer<float4>&, const Buffer<float>&, int>(spheres, weights, count); }

    /// True if they are worth their rays for what is emitted, too.
    bool shine() const;

    int count = 0;
    std::vector<Spot> found;
    Buffer<float4> spheres;
    Buffer<float> weights;
};

/// What each of the surfels sends of `radiance` [3][capacity], rgb together; 0 where that is no number.
std::vector<float> light_of(const Surfels& surfels, const Buffer<float>& radiance);

/// Spots among surfels that send `radiance` [3][capacity].
std::vector<Spot> find_spots(const Surfels& surfels, const Buffer<float>& radiance, float reach);

}  // namespace pencil
