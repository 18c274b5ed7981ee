// The world set: surface pencils wherever light is reflected, and their irradiance after all bounces.
#pragma once

#include "transport/render.h"
#include "transport/stage_clock.h"
#include "transport/surface_pencils.h"

namespace pencil {

/// How finely the world set is sampled.
struct WorldSet {
    int pencils = 1000;    // about so many if every surface reflects light that matters
    int light_stride = 4;  // texels take every so many-th light sample
};

class SurfaceSolver {
public:
    SurfaceSolver(Kernels& kernels, const DeviceScene& scene, const FlatScene& flat, const DeviceBvh& bvh, const LightSet& lights,
                  const WorldSet& set, StageClock& clock, std::uint64_t seed);

    /// Places pencils on what the texels of `seeds` see, then on what those see, and so on, until the surfaces that matter are covered;
    /// then iterates bounces. Orders of reflection up to `orders` (-1: until the tolerance).
    void solve(SurfacePencils& seeds, int orders, double tolerance);

    /// Sums of pencils first .. first + count of a set over all that their texels send, after solve().
    void gather(SurfacePencils& pencils, int first, int count) { gather(pencils, first, count, {true, direct_, true}); }

    const SurfacePencils& world() const { return world_; }
    bool stopped() const { return clock_.stopped(); }
    double residual() const { return residual_; }

private:
    /// Which radiance of what they see the texels send: emission that the maps carry, reflected light of the light samples, reflected
    /// irradiance of the world set.
    struct Sent {
        bool emission, direct, bounces;
    };
    void gather(SurfacePencils& pencils, int first, int count, Sent sent);
    std::vector<int> choose(const Surfels& surfels, const std::vector<bool>& skip, float spacing);
    void reserve(int texels);
    void link();
    bool fill();
    std::vector<float4> irradiance(Sent sent);
    void iterate(int orders, double tolerance);

    Kernels& kernels_;
    const DeviceScene& scene_;
    const FlatScene& flat_;
    const DeviceBvh& bvh_;
    const LightSet& lights_;
    WorldSet set_;
    StageClock& clock_;
    uint seed_;
    SurfacePencils world_;
    DeviceGrid grid_;
    Surfels surfels_, world_surfels_;
    Buffer<glm::ivec4> links_;
    Buffer<float4> factors_;
    Buffer<float> distances_, outgoing_;
    float spacing_ = 0;
    bool direct_ = true;  // reflections of order 2 are part of the image
    double residual_ = 0;
    std::vector<SurfacePencil> placed_;
    std::map<std::tuple<int, int, int>, std::vector<std::size_t>> cells_;
};

}  // namespace pencil
