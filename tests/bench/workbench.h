// The data that benchmarks work on: the Cornell box, its film, a set of pencils with radiance, light samples; made by the product's own
// stages, and copied to the host for the native loops.
#pragma once

#include <vector>

#include "bench/bench.h"
#include "bench/native/native.h"
#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"
#include "device/surfels.h"
#include "film/film.h"
#include "scene/scene.h"

namespace pencil::bench {

/// Scene, film, light samples, a filled pencil set, and the surfels of the next set's maps.
struct Workbench {
    Workbench();

    Scene scene;
    FlatScene flat;
    Kernels kernels;
    DeviceScene on_device;
    Film film;
    LightSet lights;
    PencilSet set;
    std::shared_ptr<GeometryMaps> next_maps;
    Surfels texel_surfels;

    native::SceneView view() const;
};

/// Made at the first use.
Workbench& workbench();

/// Host copy of geometry maps; cells and groups are the native loop's own.
struct HostMaps {
    HostMaps(const GeometryMaps& maps, const native::SceneView& scene);
    native::MapsView view() const { return {cops.data(), static_cast<int>(cops.size()), n, hits.data(), cells.data(), groups.data()}; }

    int n;
    std::vector<float4> cops;
    std::vector<Hit> hits;
    std::vector<glm::ivec2> cells;
    std::vector<glm::ivec4> groups;
};

struct HostSurfels {
    explicit HostSurfels(const Surfels& surfels) : capacity(surfels.capacity), count(surfels.count), data(surfels.data.read()) {}
    native::SurfelsView view() const { return {data.data(), static_cast<std::size_t>(capacity), count}; }

    int capacity, count;
    std::vector<float> data;
};

/// Rgb per surfel of a buffer, without what lies beyond the count.
std::vector<float> used_rgb(const std::vector<float>& rgb, int capacity, int count);

/// The triangle of each hit.
std::vector<int> triangles_of(const std::vector<Hit>& hits);

/// Words such as "262144 surfels x 128 pencils".
std::string product(long long a, const std::string& of_a, long long b, const std::string& of_b);

}  // namespace pencil::bench
