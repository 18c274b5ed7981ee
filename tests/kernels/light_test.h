// Light samples and a room for the kernels of direct light.
#pragma once

#include "kernels/kernel_test.h"

namespace pencil::test {

/// Point lights in the room and area samples; the area samples hang in the air, so they have no plane.
inline std::vector<LightSample> random_lights(Random& random, int count) {
    std::vector<LightSample> out;
    for (int i = 0; i < count; ++i) {
        LightSample s{};
        const bool area = random.uniform() < 0.7;
        s.position = to_float4(random.in_box(-0.7, 0.7), area ? 1.0 : 0.0);
        if (area) s.normal = to_float4(random.direction(), std::pow(10.0, random.uniform(-5, -1)));
        s.emission = to_float4(random.in_box(0.1, 4.0), -1.0);
        out.push_back(s);
    }
    return out;
}

/// A room with things in it, whose light samples are reached by rays.
struct RayRoom {
    RayRoom(std::uint32_t seed, int things, int light_count, int surfel_count = 768, bool wide = false)
        : random(seed),
          scene(room_scene(seed + 1, things)),
          kernels(device(), with_bvh(wide)),
          on_device(device(), scene.flat, build_hierarchy(scene.flat, wide)),
          samples(random_lights(random, light_count)),
          lights(device(), samples, 0),
          surfels(gathered(kernels, on_device, random_centres(random, 3), 16, surfel_count)) {}

    Random random;
    TestScene scene;
    Kernels kernels;
    DeviceScene on_device;
    std::vector<LightSample> samples;
    LightSet lights;
    Surfels surfels;

private:
    static Features with_bvh(bool wide) {
        Features features;
        features.bvh = true;
        features.wide_bvh = wide;
        return features;
    }
};

}  // namespace pencil::test
