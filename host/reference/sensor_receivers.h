// The sensor points of a scene as points that paths begin at.
#pragma once

#include "reference/ray_scene.h"
#include "reference/sampler.h"
#include "scene/sensor_places.h"

namespace pencil {

class SensorReceivers {
public:
    /// Both scenes must outlive this.
    SensorReceivers(const Scene& scene, const RayScene& rays) : places_(scene), rays_(rays) {}

    bool empty() const { return places_.size() == 0; }
    /// A place of sensor i; of its hit what PathIntegrator::trace_receiver asks for.
    RayHit at(std::size_t i, Sampler& sampler) const;

private:
    SensorPlaces places_;
    const RayScene& rays_;
};

}  // namespace pencil
