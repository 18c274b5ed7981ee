// What the reference path tracer can be asked for.
#pragma once

#include <cstdint>
#include <memory>

#include "options/pencil_field.h"

namespace pencil {

constexpr int depth_of_scene = -2;  // ReferenceOptions::max_depth: the scene's

struct ReferenceOptions {
    int spp = 256;                   // camera paths per pixel; not used if `seconds` is given
    double seconds = 0;              // budget of tracing (the BVH's build apart), kept to within half a path per pixel; 0: go by `spp`
    int max_depth = depth_of_scene;  // 1 is emission, 2 direct light, -1 no limit
    int width = 0, height = 0;       // 0: the scene's film size [pixels]
    std::uint64_t seed = 0;
    int threads = 0;          // that trace; 0: all cores
    bool irradiance = false;  // irradiance / pi of what a pixel sees instead of its radiance
    bool bounces = false;     // layers "emission", "direct", "bounce2" ..., and the tail of the orders beyond
    bool surfaces = false;    // layers "albedo", "depth", "position", "normal"
    bool variance = false;    // layer "variance": of the mean in each pixel and channel, from independent sets of samples, which are
                              // stratified less than one: the image is noisier
    std::shared_ptr<const PencilField> field;  // the image is the reflected light of its maps, whose centres and width count; no camera
};

}  // namespace pencil
