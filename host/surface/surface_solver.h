// Light of surface pencils: the world set's irradiance after all bounces, and what film pencils gather from it.
#pragma once

#include <functional>

#include "device/pencil_set.h"
#include "device/stage_clock.h"
#include "film/bounce_series.h"
#include "surface/follow_surfels.h"
#include "surface/gather_team.h"
#include "surface/gatherer.h"
#include "surface/spot_search.h"
#include "surface/surface_lights.h"
#include "surface/world_guides.h"
#include "surface/world_set.h"
#include "util/archive.h"

namespace pencil {

/// How finely the world set is sampled.
struct WorldQuality {
    int pencils = 1000;   // about so many if every surface reflects light that matters
    int light_draws = 4;  // light samples of a packet of texels
    int thrift = 0;       // halvings of what is worked on at once
};

class SurfaceSolver {
public:
    /// What the next solve() needs of those before, but for the world set.
    struct Course {
        std::uint64_t gathers = 0;
        bool looked_for_spots = false;
        std::vector<Spot> spots;
        void transfer(Archive& archive) { archive(gathers, looked_for_spots, spots); }
    };

    SurfaceSolver(Kernels& kernels, const DeviceScene& scene, SurfaceLights lights, const WorldQuality& quality, StageClock& clock,
                  uint seed, HelperReport& helpers);
    /// Another device shares what is gathered from now on.
    void add_helper(DeviceCopy& copy, const std::function<SurfaceLights()>& lights);

    /// Places the world set from what the texels of `seeds` see; `spacing`: see WorldSet::cover.
    void place(const SurfacePencils& seeds, float spacing);

    /// Gathers anew with maps of `map` x `map` texels and iterates bounces. Orders of reflection up to `orders` (-1: until the tolerance). Each seed sees other points.
    void solve(int map, int orders, double tolerance, std::uint64_t seed);

    /// What pencils first .. first + count of a set see and receive, after solve().
    void gather(SurfacePencils& pencils, int first, int count, const TexelPoints& points, Reach reach);

    /// Chains that start on surfels `starts` of the film, `shared` one after the other on the same,
    Chains follow(const Surfels& film, const Buffer<int>& starts, const FilmChains& each);
    /// and what they find: radiance[3][capacity of `chains`] that they carry [W m^-2 sr^-1], emission and reflections.
    Buffer<float> radiance(const Surfels& chains);

    /// What surfels seen by pencils in free space send to them, added to radiance[3][capacity] [W m^-2 sr^-1]: light of the samples and of the world
    /// set, reflected. Those with lobes become what these show, emission too.
    void light_field(Surfels& seen, const Viewers& viewers, std::uint64_t seed, Buffer<float>& radiance);

    Course course() const;
    /// Goes on as the solver of the same world set whose course this was.
    void resume(const Course& course);
    /// Bright spots that other world sets of the scene have found: rays go to them from the first solve() on.
    void know(const std::vector<Spot>& spots);

    WorldSet::Missed missed(const SurfacePencils& looks) const;
    const SurfacePencils& world() const { return world_.pencils(); }
    /// WorldSet's, after solve().
    double light_to_film() const { return world_.light_to_film(); }
    double world_rays() const { return world_.rays(); }
    float spacing() const { return world_.spacing(); }
    bool stopped() const { return clock_.stopped(); }
    /// About what of the world's light is missing, relative to it.
    double residual() const { return residual_; }
    /// How the world's bounces were added up.
    const BounceSolve& bounces() const { return bounces_; }
    /// Bright spots that film pencils send rays of their own to.
    int spots() const { return spots_.count; }

private:
    /// Of emitters near pencils or carried by maps; of light samples, reflected.
    enum class Light { emission, direct };
    void sum_light(Light light, Buffer<float4>& irradiance);
    std::uint64_t next_seed();
    std::uint64_t seed_of_search() const;
    void iterate(int orders, double tolerance);
    void close_series(const BounceSeries& series, const Buffer<float4>& last);
    void solve_rest(const Buffer<float4>& last, double tolerance);
    GatherSource source() const;
    void inform_team();
    void look_for_spots();
    void adopt(const std::vector<Spot>& found);
    bool has_spots() const;

    Kernels& kernels_;
    const DeviceScene& scene_;
    SurfaceLights lights_;
    WorldQuality quality_;
    StageClock& clock_;
    uint seed_;
    WorldSet world_;
    Gatherer gatherer_;
    SpotSearch search_;
    WorldGuides guides_;
    GatherTeam team_;
    DeviceSpots spots_;
    bool looked_ = false;        // this world set has looked for spots
    Buffer<float4> shorter_;     // irradiance of the world set up to one order less, if orders are limited
    bool direct_ = true;         // reflections of order 2 are part of the image
    bool contacts_ = true;       // and of order 3
    bool limited_ = false;       // not all orders are
    std::uint64_t gathers_ = 0;  // so far: each draws other light samples
    double residual_ = 0;
    BounceSolve bounces_;
};

}  // namespace pencil
