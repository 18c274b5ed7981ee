// Rays of the world set's pencils towards bright spots, beside those of their texels.
#pragma once

#include "surface/gatherer.h"
#include "surface/world_set.h"

namespace pencil {

class WorldGuides {
public:
    explicit WorldGuides(Kernels& kernels) : kernels_(kernels) {}

    /// Traces them after the world set has gathered, as many as its texels; without spots there are none.
    void trace(Gatherer& gatherer, const DeviceSpots& spots, std::uint64_t seed, const WorldSet& world);

    /// radiance[3][capacity] that the world set's texels send becomes the share that the rays leave them.
    void share(const WorldSet& world, Buffer<float>& radiance) const;
    /// Adds what the rays carry to the irradiance of the pencils [W m^-2]: what spots emit,
    void add_emission(Gatherer& gatherer, const Buffer<float>& near_area, const WorldSet& world, Buffer<float4>& irradiance);
    /// or what they reflect of the light samples.
    void add_light(Gatherer& gatherer, const WorldSet& world, Buffer<float4>& irradiance);

    bool any() const { return any_; }
    /// What is emitted is among what the rays carry.
    bool shine() const { return any_ && spots_.shine(); }

private:
    void add(const WorldSet& world, Buffer<float4>& irradiance);

    Kernels& kernels_;
    bool any_ = false;
    DeviceSpots spots_;
    GatherTurn turn_{};
    Gatherer::Guided guided_;
};

}  // namespace pencil
