// A film whose indirect light is made for every third pixel of every third row, and for edges: launchers of kernels/thin_film.cl, pick_surfels.cl and
// spread_light.cl.
#pragma once

#include "device/features.h"
#include "device/surfels.h"
#include "film/film.h"

namespace pencil {

class ThinFilm {
public:
    ThinFilm(Kernels& kernels, const Film& film);

    /// Those that need light of their own, as if they were white.
    const Surfels& surfels() const { return picked_; }
    /// Adds to `outgoing` of the film what its surfels reflect of `light`, irradiance over pi of surfels() [W m^-2 sr^-1].
    void spread(Kernels& kernels, const Buffer<float>& light, Buffer<float>& outgoing) const;

private:
    const Film& film_;
    Surfels picked_;
    Buffer<int> place_;  // of each surfel of the film among those, -1: none
};

}  // namespace pencil
