// Where pencils may lie: outside solids (thesis 6.1.1, "reject points inside objects").
#pragma once

#include <set>

#include "pencils/place_pencils.h"
#include "transport/device_scene.h"
#include "transport/features.h"
#include "transport/pencil_set.h"

namespace pencil {

/// A centre is inside a solid if the backs of one shape fill more than half of what it sees, and that shape is not a room. A shape is a
/// room if the camera or a light sample is inside it by the same measure. So closed and nearly closed meshes are solids; open meshes,
/// single walls, and rooms modelled with their fronts outwards are not. A centre in a sealed void that sees only fronts is kept: it is
/// harmless, because no surfel that is lit or seen has a line to it.
class FreeSpace {
public:
    /// `lights` may be null.
    FreeSpace(Kernels& kernels, const DeviceScene& scene, const FlatScene& flat, const GeometryMaps* lights, int map_size);

    /// Geometry maps of `count` centres of set number `set`, rasterised and folded; centres inside solids are replaced by the next of the
    /// sequence. After kMostRounds rounds what is left is kept as it is.
    std::shared_ptr<GeometryMaps> create(Kernels& kernels, Sequence sequence, int count, int set, std::uint64_t seed) const;

    /// Shapes found to be rooms.
    const std::set<int>& rooms() const { return rooms_; }

    static constexpr int kMostRounds = 16;

private:
    std::vector<bool> accepted(Kernels& kernels, const GeometryMaps& maps) const;

    const DeviceScene& scene_;
    const FlatScene& flat_;
    int map_size_;
    std::set<int> rooms_;
};

}  // namespace pencil
