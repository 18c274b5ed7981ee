// What the texels of surface pencils see, on the host: read from the device once, however often it is looked at.
#pragma once

#include <glm/vec3.hpp>

#include "device/surfels.h"
#include "surface/surface_pencils.h"

namespace pencil {

class SeenPoints {
public:
    struct Point {
        glm::vec3 position, normal;  // [scene units]; normal 0: nothing is seen
        float albedo;                // the largest component
    };

    /// Reads the pencils of a set that were appended since the last call with it, which follows those with other sets: places, normals and radii,
    /// which never change. All sets have maps of one width.
    void read_pencils(const SurfacePencils& set);
    /// Reads the surfels that were appended since the last call, in one transfer.
    void read_points(const Surfels& surfels);

    const std::vector<SurfacePencil>& pencils() const { return pencils_; }
    const std::vector<Point>& points() const { return points_; }
    /// Where point i was seen from [scene units].
    glm::vec3 viewer(std::size_t i) const { return glm::vec3(pencils_[i / texels_].position); }

private:
    std::size_t texels_ = 1;  // per pencil
    const SurfacePencils* last_set_ = nullptr;
    std::size_t before_ = 0;  // pencils of the sets before
    std::vector<SurfacePencil> pencils_;
    std::vector<Point> points_;
};

}  // namespace pencil
