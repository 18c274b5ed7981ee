#include "surface/world_guides.h"

#include "surface/share_hemispheres.h"
#include "surface/sum_guides.h"

namespace pencil {

void WorldGuides::trace(Gatherer& gatherer, const DeviceSpots& spots, std::uint64_t seed, const WorldSet& world) {
    any_ = spots.count > 0 && world.pencils().count > 0;
    if (!any_) return;
    // Spots that are found later count from the next gather on.
    spots_ = DeviceSpots(kernels_.device(), spots.found);
    turn_ = {world.points(), Reach::own, seed};
    gatherer.guide(spots_, turn_, world.starts(), 0, world.starts().count, Keys::shared, guided_);
}

void WorldGuides::share(const WorldSet& world, Buffer<float>& radiance) const {
    share_hemispheres(kernels_, world.starts(), 0, world.starts().count, spots_, world.points(), radiance, world.surfels().capacity,
                      world.map());
}

void WorldGuides::add_emission(Gatherer& gatherer, const Buffer<float>& near_area, const WorldSet& world, Buffer<float4>& irradiance) {
    guided_.found.outgoing.fill_zero();
    gatherer.emit_guided(world.starts(), 0, near_area, guided_);
    add(world, irradiance);
}

void WorldGuides::add_light(Gatherer& gatherer, const WorldSet& world, Buffer<float4>& irradiance) {
    guided_.found.outgoing.fill_zero();
    gatherer.light_guided(turn_, world.starts(), 0, Keys::shared, guided_);
    add(world, irradiance);
}

void WorldGuides::add(const WorldSet& world, Buffer<float4>& irradiance) {
    const int count = world.pencils().count, rays = guided_.found.surfels.count / count;
    sum_guides(kernels_, guided_.found.outgoing, guided_.found.surfels.capacity, guided_.factors, rays, 0, count, irradiance);
}

}  // namespace pencil
