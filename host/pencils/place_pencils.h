// Centres of projection in the free space of the scene (thesis 6.1.1): positions in the bounding box, rejected inside solids.
#pragma once

#include <vector>

#include "pencils/flat_scene.h"

namespace pencil {

/// Decides whether a point lies inside a solid. Only closed shapes (every edge shared by two triangles of opposite sense) enclose
/// anything; open meshes and single walls do not. A point is inside a closed shape if its winding number about it is not 0, and that shape
/// is a solid if neither the camera nor any light lies inside it: otherwise it is a room.
class Solids {
public:
    Solids(const Scene& scene, const FlatScene& flat);
    bool contains(const glm::dvec3& point) const;
    std::size_t count() const { return solids_.size(); }

private:
    struct Solid {
        glm::dvec3 low, high;
        std::vector<glm::dvec3> corners;  // three per triangle
        bool encloses(const glm::dvec3& point) const;
    };
    std::vector<Solid> solids_;
};

enum class Sequence { random, low_discrepancy };

/// `count` points of the set number `set` (each set has its own shift or stream). If nearly all of the box is solid, the rest of the
/// points is placed regardless, after kMaxTries per point.
std::vector<float4> place_pencils(const FlatScene& flat, const Solids& solids, Sequence sequence, int count, int set, std::uint64_t seed);

}  // namespace pencil
