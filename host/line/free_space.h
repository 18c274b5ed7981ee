// Where pencils may lie: outside solids (thesis 6.1.1, "reject points inside objects"), and in the space that the film and the lights
// share.
#pragma once

#include <glm/vec3.hpp>
#include <set>
#include <vector>

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"
#include "device/surfels.h"
#include "line/placement/candidate_source.h"

namespace pencil {

/// Where centres lie [normalised scene units].
struct CentreSpace {
    glm::dvec3 low{0}, high{0};
    double volume = 0;
};

/// Two rules, both decided by what a centre's own maps show:
/// - A centre is inside a solid if the backs of one shape fill more than half of what it sees, and that shape is not a room. A shape is a
///   room if the camera or a light sample is inside it by the same measure. So closed and nearly closed meshes are solids; open meshes,
///   single walls, and rooms modelled with their fronts outwards are not.
/// - A centre must see a reached side of a shape. Reached are the sides that the film or a light sample shows, and all that an accepted
///   centre sees. A centre that meets none of them has no line to a surface that matters: it lies outside a closed room, or in a sealed
///   void. This loses no light, since a centre that lights a surface point sees the side on which that point lies.
class FreeSpace {
public:
    /// `film` gives the surfels of the image. `lights` may be null.
    FreeSpace(Kernels& kernels, const DeviceScene& scene, const FlatScene& flat, const Surfels& film, const GeometryMaps* lights,
              int map_size);
    /// Of centres that are given, uniform in `share` of the scene's box: no rooms are looked for and nothing is created.
    FreeSpace(const DeviceScene& scene, const FlatScene& flat, double share) : scene_(scene), flat_(flat), given_share_(share) {}

    /// Another share for given centres.
    void set_share(double share) { given_share_ = share; }

    /// Geometry maps of `count` centres of set number `set`, rasterised and folded; rejected centres are replaced by the next of the
    /// source. If most_rounds rounds do not find all, the set is smaller; if they find none, the last round's centres are taken.
    std::shared_ptr<GeometryMaps> create(Kernels& kernels, CandidateSource& source, int count, int set, const PowerSeen& power = {});

    /// Shapes found to be rooms.
    const std::set<int>& rooms() const { return rooms_; }
    /// Candidates rejected so far by each rule.
    int in_solids() const { return in_solids_; }
    int unreached() const { return unreached_; }
    /// The box of the candidates, and by the share of them accepted so far the volume of the part of it where centres are.
    CentreSpace space() const;
    double share() const;

    static constexpr int most_rounds = 16;

private:
    void reach_film(const Surfels& film);
    bool reach_row(const uint* row);
    bool meets_reached(const uint* row) const;
    std::vector<bool> accepted(Kernels& kernels, const GeometryMaps& maps);

    const DeviceScene& scene_;
    const FlatScene& flat_;
    int map_size_ = 0;
    std::set<int> rooms_;
    std::vector<uint> reached_;  // bit set of sides, see find_sides.h
    bool any_reached_ = false;
    int candidates_ = 0, in_solids_ = 0, unreached_ = 0;
    double given_share_ = -1;  // below 0: it follows from those
};

}  // namespace pencil
