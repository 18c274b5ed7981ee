#include "bench/workbench.h"

#include "line/free_space.h"
#include "line/gather_surfels.h"
#include "line/pencil_solver.h"
#include "pencils/light_samples.h"
#include "scene/formats/load_scene.h"
#include "visibility/rasterize_octahedral.h"

namespace pencil::bench {
namespace {

Scene cornell_box() { return load_scene(PENCIL_SOURCE_DIR "/scenes/cornell-box.xml", {}); }

std::vector<LightForm> sampled(const Scene& scene) { return choose_light_forms(scene, true, false); }

RenderOptions options() {
    RenderOptions options;
    options.method = MethodName::line;
    options.pencils = sizes().pencils;
    options.map = sizes().map;
    options.film_samples = sizes().film_samples;
    return options;
}

LightSet make_lights(Kernels& kernels, const DeviceScene& on_device, const Scene& scene, const FlatScene& flat) {
    LightSet lights(device(), sample_lights(scene, flat, sampled(scene), sizes().light_samples, 0), sizes().light_map);
    rasterize_octahedral(kernels, on_device, lights.maps, 0, lights.maps.count);
    return lights;
}

}  // namespace

Workbench::Workbench()
    : scene(cornell_box()),
      flat(flatten(scene, sampled(scene), sizes().film, sizes().film)),
      kernels(device(), scene_features(flat, options().film_samples, false)),
      on_device(device(), flat),
      film(kernels, on_device, FilmCamera{flat.camera, glm::vec3(flat.eye)}, scene.sensor.filter, Turn()),
      lights(make_lights(kernels, on_device, scene, flat)) {
    const RenderOptions settings = options();
    StageClock clock(device(), {});
    FreeSpace free_space(kernels, on_device, flat, film.surfels(), &lights.maps, settings.map);
    const auto candidates = make_candidate_source({kernels, on_device, scene, flat, settings.seed}, {Placement::lds});
    PencilSolver solver(kernels, on_device, free_space, *candidates, lights, settings, clock);
    set = solver.create(0, nullptr, false, true);
    solver.fill(set, nullptr, false, true, true);
    next_maps = free_space.create(kernels, *candidates, sizes().tiles, 1);
    texel_surfels = Surfels(device(), sizes().tiles * settings.map * settings.map, "surfels of pencil maps");
    gather_surfels(kernels, on_device, *next_maps, 0, sizes().tiles, texel_surfels);
}

native::SceneView Workbench::view() const {
    return {flat.triangles.data(), static_cast<int>(flat.triangles.size()), flat.planes.data(), flat.materials.data()};
}

Workbench& workbench() {
    static Workbench made;
    return made;
}

HostMaps::HostMaps(const GeometryMaps& maps, const native::SceneView& scene)
    : n(maps.n), cops(maps.cops.read()), hits(maps.hits.read()), cells(hits.size()), groups(hits.size()) {
    native::fold_hits(scene, cops.data(), maps.count, n, hits.data(), cells.data(), groups.data());
}

std::vector<float> used_rgb(const std::vector<float>& rgb, int capacity, int count) {
    std::vector<float> out;
    for (int c = 0; c < 3; ++c) {
        const auto first = rgb.begin() + static_cast<std::ptrdiff_t>(c) * capacity;
        out.insert(out.end(), first, first + count);
    }
    return out;
}

std::vector<int> triangles_of(const std::vector<Hit>& hits) {
    std::vector<int> out;
    out.reserve(hits.size());
    for (const Hit& hit : hits) out.push_back(hit.triangle);
    return out;
}

std::string product(long long a, const std::string& of_a, long long b, const std::string& of_b) {
    return std::to_string(a) + " " + of_a + " x " + std::to_string(b) + " " + of_b;
}

}  // namespace pencil::bench
