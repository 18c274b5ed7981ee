// The world set: surface pencils wherever light is reflected that matters to the film, what they see, and which of them stand for what they
// see.
#pragma once

#include "pencils/thin_points.h"
#include "surface/follow_surfels.h"
#include "surface/link_surfels.h"
#include "surface/place_surface_pencils.h"
#include "surface/seen_points.h"
#include "surface/shared_points.h"
#include "surface/trace_hemispheres.h"

namespace pencil {

class WorldSet {
public:
    /// `wish`: about so many pencils if every surface reflects light that matters; `seed`: of the points within texels; `lights`: that chains of lobes meet, which must
    /// outlive the set.
    WorldSet(Kernels& kernels, const DeviceScene& scene, int wish, uint seed, const LobeLights& lights);

    /// Places pencils on what the texels of `seeds` see, then on what those see, and so on, until all that is seen is covered. `spacing`: a
    /// guess of spacing(), 0: none. Pencils of before are gone.
    void cover(const SurfacePencils& seeds, float spacing = 0);
    /// What seeds have missed, as other pencils that look about say.
    struct Missed {
        std::vector<uint> keys;  // of those that see something which reflects and which no pencil stands for
        double share = 0;        // of all that reflects and is seen
    };
    Missed missed(const SurfacePencils& looks) const;
    /// With which as many pencils as wished for lie on what is seen [scene units].
    float spacing() const { return spacing_; }
    /// From which things are seen: the median of all such distances [scene units]; a harmonic mean would be that of the closest contacts.
    float seen_distance() const { return seen_distance_; }
    /// What all pencils see, each from some of the points that read it; other seeds, other points. Maps of `map` x `map` texels.
    void gather(int map, std::uint64_t seed);

    /// Adds to radiance[3][capacity] [W m^-2 sr^-1] what surfels, seen by viewers, reflect of the pencils' irradiance.
    void add_reflected(const Surfels& surfels, const Viewers& viewers, Buffer<float>& radiance) const;

    /// About how much light the film receives from all pencils, as they are lit now; in units of its own, the same until pencils are placed anew.
    double light_to_film() const;
    /// Of a gather.
    double rays() const { return static_cast<double>(pencils_.count) * map_ * map_; }

    SurfacePencils& pencils() { return pencils_; }
    const SurfacePencils& pencils() const { return pencils_; }
    const DeviceGrid& grid() const { return grid_; }

    /// What seeds and pencils see from their centres, by which pencils are placed, and who sees it.
    const Surfels& seen_from_centres() const { return seen_surfels_; }
    const SeenPoints& seen_points() const { return seen_; }
    SurfacePencils centres() const;
    /// Of all that is seen so, the mean of the largest components.
    float seen_albedo() const;

    /// After gather: what the pencils' texels see, their number for each pencil, and which pencils light them.
    const Surfels& surfels() const { return surfels_; }
    int map() const { return map_; }
    const SurfaceLinks& links() const { return links_; }
    /// Where they see it from: `starts().texels()` of each map in turn.
    const SurfacePencils& starts() const { return starts_; }
    const TexelPoints& points() const { return points_; }

private:
    struct Spacing {
        float width;       // [scene units]
        std::size_t most;  // pencils
    };
    struct SpacedPoint {
        float spacing;  // [scene units]
        std::size_t index;
    };

    std::vector<SpacedPoint> by_spacing(int first, float width, const std::vector<bool>& skip) const;
    float spacing_for(std::size_t count, float guess);
    ChosenSurfels choose(int first, Spacing spacing, PointThinner& thinner, const std::vector<bool>& skip = {}) const;
    void extend(const ChosenSurfels& chosen);
    void fill(const Spacing& spacing);
    void follow(int first, uint seed, Surfels& surfels) const;
    PointLinks link_seen();
    std::vector<SurfacePencil> pencils_on_host() const;

    Kernels& kernels_;
    const DeviceScene& scene_;
    const LobeLights& lights_;
    int wish_;
    uint seed_;
    SurfacePencils pencils_;
    std::vector<int> sources_;  // of each pencil: the surfel that it was placed on
    DeviceGrid grid_;

    // What the seeds see, then what the pencils see from their centres, and host copies of both with seeds and pencils.
    int seeds_ = 0;
    float spacing_ = 0, seen_distance_ = 0;
    Surfels seen_surfels_;
    SeenPoints seen_;
    SharedPoints shared_;

    TexelPoints points_;
    int map_ = 0;
    SurfacePencils starts_;
    Surfels surfels_;
    SurfaceLinks links_;
};

}  // namespace pencil
