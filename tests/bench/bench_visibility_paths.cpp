// Three ways to make geometry maps (visibility/visibility_path.h), over scenes of few and of many triangles. They are compared with each
// other, not with a native loop. Time is the device's for the hits alone: folding is the same for all. Counter `prepare`: seconds of the
// host for clusters or hierarchy, once per scene.
#include <algorithm>
#include <memory>

#include "bench/workbench.h"
#include "pencils/light_samples.h"
#include "pencils/place_pencils.h"
#include "scene/formats/load_scene.h"
#include "util/stopwatch.h"
#include "visibility/rasterize_clusters.h"
#include "visibility/rasterize_octahedral.h"
#include "visibility/trace_maps.h"

namespace pencil::bench {
namespace {

using MakeMaps = void (*)(Kernels&, const DeviceScene&, GeometryMaps&, int, int);

struct Path {
    const char* name;
    const char* launch;
    MakeMaps make;
};
const Path paths[] = {{"rasterize", "rasterize octahedral maps", rasterize_octahedral},
                      {"clusters", "rasterize clusters", rasterize_clusters},
                      {"trace", "trace geometry maps", trace_maps}};

/// A scene in device memory with all that the paths need.
struct Subject {
    explicit Subject(const std::string& name)
        : scene(load_scene(PENCIL_SOURCE_DIR "/scenes/" + name + ".xml", {})),
          flat(flatten(scene, choose_light_forms(scene, true, false), 8, 8)),
          kernels(device(), scene_features(flat, sizes().film_samples, false)) {
        Stopwatch watch;
        const Clusters clusters = cluster_triangles(flat.triangles);
        seconds[1] = watch.seconds();
        const Bvh bvh = build_bvh(flat.triangles);
        seconds[2] = watch.seconds() - seconds[1];
        on_device = std::make_unique<DeviceScene>(device(), flat, bvh, clusters);
    }
    Scene scene;
    FlatScene flat;
    Kernels kernels;
    std::unique_ptr<DeviceScene> on_device;
    double seconds[3] = {0, 0, 0};
};

Subject& subject(const std::string& name) {
    static std::map<std::string, std::unique_ptr<Subject>> made;
    std::unique_ptr<Subject>& entry = made[name];
    if (!entry) entry = std::make_unique<Subject>(name);
    return *entry;
}

std::vector<int> shown_triangles(const GeometryMaps& maps) {
    std::vector<int> out;
    for (const Hit& hit : maps.hits.read()) out.push_back(hit.triangle);
    return out;
}

void make_maps(benchmark::State& state, const std::string& name, int most, int n, int index) {
    const int count = std::min(most, sizes().most_maps);
    Subject& s = subject(name);
    const Path& path = paths[index];
    const std::vector<float4> centres = place_pencils(s.flat, Sequence::low_discrepancy, 0, count, 0, 0);
    GeometryMaps maps(device(), centres, n, "bench"), expected(device(), centres, n, "bench");
    const std::string triangles = ", " + std::to_string(s.on_device->triangle_count) + " triangles";
    time_alone(
        state, {product(count, "maps", static_cast<long long>(n) * n, "texels") + triangles, 1.0 * count * n * n, 0, {path.launch}},
        [&] { path.make(s.kernels, *s.on_device, maps, 0, count); },
        [&] {
            rasterize_octahedral(s.kernels, *s.on_device, expected, 0, count);
            return differences(shown_triangles(maps), shown_triangles(expected), 1e-3);
        });
    state.counters["prepare"] = s.seconds[index];
}

struct Batch {
    int count, n;
};

void register_paths(const std::string& scene, const Batch& batch) {
    for (int path = 0; path < 3; ++path)
        benchmark::RegisterBenchmark(
            ("visibility_paths/" + scene + "/" + std::to_string(batch.count) + "x" + std::to_string(batch.n) + "/" + paths[path].name)
                .c_str(),
            [=](benchmark::State& state) { make_maps(state, scene, batch.count, batch.n, path); })
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond);
}

[[maybe_unused]] const bool registered = [] {
    for (const char* scene : {"colonnade", "door-ajar", "cornell-box"})
        for (const Batch& batch : {Batch{328, 8}, Batch{328, 16}, Batch{128, 64}, Batch{64, 256}}) register_paths(scene, batch);
    return true;
}();

}  // namespace
}  // namespace pencil::bench
