// The world set: surface pencils wherever light is reflected that matters to the film, what they see, and which of them stand for what they
// see.
#pragma once

#include "pencils/thin_points.h"
#include "surface/link_surfels.h"
#include "surface/place_surface_pencils.h"
#include "surface/seen_points.h"
#include "surface/trace_hemispheres.h"

namespace pencil {

class WorldSet {
public:
    /// `wish`: about so many pencils if every surface reflects light that matters; `seed`: of the points within texels.
    WorldSet(Kernels& kernels, const DeviceScene& scene, const FlatScene& flat, int wish, uint seed);

    /// Places pencils on what the texels of `seeds` see, then on what those see, and so on, until all that is seen is covered; then more
    /// where what is seen lies beyond the reach of all: behind edges, in corners and near contacts.
    void cover(const SurfacePencils& seeds);

    SurfacePencils& pencils() { return pencils_; }
    const SurfacePencils& pencils() const { return pencils_; }
    const Surfels& surfels() const { return surfels_; }  // what their texels see, texels() per pencil
    const DeviceGrid& grid() const { return grid_; }
    const SurfaceLinks& links() const { return links_; }  // of the surfels

private:
    ChosenSurfels choose(const SeenPoints& seen, int first, const std::vector<bool>& skip, PointThinner& thinner) const;
    int extend(const Surfels& surfels, const ChosenSurfels& chosen);
    int fill(const Surfels& surfels, const SeenPoints& seen, const SurfaceLinks& links, PointThinner& thinner);
    void link();

    Kernels& kernels_;
    const DeviceScene& scene_;
    const FlatScene& flat_;
    int wish_;
    uint seed_;
    float spacing_;
    SurfacePencils pencils_;
    Surfels surfels_;
    SeenPoints seen_;  // host copies of both
    DeviceGrid grid_;
    SurfaceLinks links_;
};

}  // namespace pencil
