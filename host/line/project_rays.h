// Launcher of kernels/project_rays.cl: rays that surfels send themselves, beside the lines of pencils.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"
#include "device/surfels.h"
#include "line/free_space.h"
#include "line/weights.h"
#include "options/render_options.h"

namespace pencil {

/// Which rays: side^2 of each surfel, random by `seed` and the surfel's number from `first_key`, modulo 2^32.
struct RayChoice {
    int count() const { return side * side; }

    int side = 0;
    std::uint32_t seed = 0;
    std::uint32_t first_key = 0;
    bool alone = false;  // no lines beside them
};

/// Those of the film's surfels for set number `index`, and of surfels of maps, which are smoothed and need fewer. All are new each time.
RayChoice film_rays(const RenderOptions& options, int index);
RayChoice map_rays(const RenderOptions& options, int index);

/// How much is done at once. What comes out does not depend on it.
struct RayStretch {
    int surfels = surfel_multiple;  // whose rays are held, a multiple of surfel_multiple
    int launch = 1;                 // rays of a launch, those of all surfels together
};

/// Enough work for the device, a launch of a tenth of a second at most, and little of its memory.
RayStretch ray_stretch(const Kernels& kernels, const RayChoice& choice, int pencils);

/// Rays of surfels `first` to `end`, at most those of a stretch, looked up in the maps of `source`, whose centres are uniform in `space`
/// [normalised scene units]. The scene has a hierarchy.
void project_rays(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, int first, int end, const PencilSet& source,
                  const CentreSpace& space, const RayChoice& choice, const RayStretch& stretch, SurfelRays& rays);

/// Adds what surfels `first` to `end` reflect of the light of their rays.
void sum_rays(Kernels& kernels, const Surfels& surfels, int first, int end, const SurfelRays& rays, Buffer<float>& outgoing);

}  // namespace pencil
