// What surface pencils gather from a world set that has been solved, on one device, some of a set at a time: nothing depends on how they are
// divided, so that devices may share a set.
#pragma once

#include "device/pencil_set.h"
#include "surface/follow_surfels.h"
#include "surface/guide_hemispheres.h"
#include "surface/pencil_grid.h"
#include "surface/project_surface_pencils.h"
#include "surface/spots.h"
#include "surface/surface_lights.h"
#include "surface/trace_hemispheres.h"

namespace pencil {

/// Surfels that texels see, what they send, and which of them are contacts.
struct Gathered {
    Surfels surfels;
    Buffer<float> outgoing;
    Buffer<unsigned char> contact;
};

/// Whom the irradiance of pencils is for: their own surfels, or others near them, too, so that emitters near them matter.
enum class Reach { own, others };

/// What is gathered from, in memory of the device.
struct GatherSource {
    const SurfacePencils& world;
    const Buffer<float4>& shorter;  // irradiance of the world set up to one order less; unallocated if orders are not limited
    const DeviceGrid& grid;
    const DeviceSpots* spots;  // that pencils send rays of their own to, null: none
    bool direct;               // reflections of order 2 are part of the image,
    bool contacts;             // and of order 3
};

/// For whom, from which points, and which light samples: the same for all pencils of a set.
struct GatherTurn {
    TexelPoints points;
    Reach reach;
    std::uint64_t seed;
};

class Gatherer {
public:
    /// `lights` must outlive it; `light_draws`: light samples that 16 texels draw; `texels`: that are worked on at once.
    Gatherer(Kernels& kernels, const DeviceScene& scene, const SurfaceLights& lights, int light_draws, int texels)
        : kernels_(kernels), scene_(scene), lights_(lights), light_draws_(light_draws), chunk_(texels) {}

    /// What pencils first .. first + count see and receive.
    void gather(const GatherSource& source, const GatherTurn& turn, SurfacePencils& pencils, int first, int count);

    // Parts of it:
    /// Room for so many texels, whose radiance becomes 0.
    void reserve(Gathered& gathered, int texels);
    /// Surfels with lobes become what these show.
    void follow(Surfels& surfels, std::uint64_t seed, const std::optional<Viewers>& viewers);
    /// Adds reflected light of the light samples.
    void light(const Surfels& surfels, Buffer<float>& outgoing, std::uint64_t seed, const std::optional<Viewers>& viewers = {});
    /// Rays of pencils towards bright spots, with how they count.
    struct Guided {
        Gathered found;
        Buffer<float> factors;
    };
    /// SPOT_RAYS of each of pencils first .. first + count, that find nothing sent yet.
    void guide(const DeviceSpots& spots, const GatherTurn& turn, const SurfacePencils& pencils, int first, int count, Keys keys,
               Guided& guided);
    /// Adds to what they find reflected light of the light samples,
    void light_guided(const GatherTurn& turn, const SurfacePencils& pencils, int first, Keys keys, Guided& guided);
    /// and emission.
    void emit_guided(const SurfacePencils& pencils, int first, const Buffer<float>& near_area, Guided& guided);

private:
    void gather_chunk(const GatherSource& source, const GatherTurn& turn, SurfacePencils& pencils, int first, int count);
    void gather_contacts(const GatherSource& source, const GatherTurn& turn, const Viewers& viewers, int count);
    /// How texels read the world set: this irradiance of its pencils, and none nearer than this share of their radius.
    struct Reading {
        const Buffer<float4>& irradiance;
        float nearness;
    };
    void emit_and_share(const GatherSource& source, const GatherTurn& turn, const Viewers& viewers, int count,
                        const Buffer<float>& near_area, Gathered& seen);
    void gather_spots(const GatherSource& source, const GatherTurn& turn, SurfacePencils& pencils, int first, int count,
                      const Reading& reading, const Buffer<float>& near_area);

    Kernels& kernels_;
    const DeviceScene& scene_;
    const SurfaceLights& lights_;
    int light_draws_, chunk_;
    Gathered seen_, beyond_;  // of one chunk, and what its contacts see
    Guided guided_;           // what it sees towards bright spots
};

}  // namespace pencil
