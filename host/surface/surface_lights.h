// What lights surface pencils: light samples, and what is known of them beforehand.
#pragma once

#include <vector>

#include "device/pencil_set.h"
#include "film/render_context.h"
#include "pencils/light_samples.h"
#include "surface/follow_surfels.h"
#include "surface/small_lights.h"

namespace pencil {

struct SurfacePass;

/// Light samples that a packet of chains of the film draws: each chain is seen by itself.
constexpr int chain_draws = 8;

/// What lights surface pencils.
struct SurfaceLights {
    LightSet samples;               // that texels draw from
    Buffer<float> near_film;        // near_areas of the film's light samples,
    Buffer<float> near_texel;       // and of those
    LobeLights film;                // the film's samples as surfels with lobes draw them,
    LobeLights drawn;               // the texels' as texels do: few of all,
    LobeLights chains;              // and as chains of the film do: some more
    std::vector<SmallLight> small;  // that may stand close to surfaces
    double power = 0;               // of all light samples, rgb together [W]
};

/// Those of the world set of `pass`, beside the film's samples, in memory of the device; `seed`: of the set.
SurfaceLights surface_lights(const RenderContext& context, const std::shared_ptr<Device>& device, const SurfacePass& pass,
                             const std::vector<LightSample>& of_film, std::uint64_t seed);

}  // namespace pencil
