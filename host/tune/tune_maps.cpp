#include "tune/tune_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "pencils/light_samples.h"
#include "stress/stress_scenes.h"
#include "visibility/rasterize_clusters.h"
#include "visibility/rasterize_octahedral.h"
#include "visibility/trace_maps.h"

namespace pencil {
namespace {

constexpr int maps_of_batch = 64;
constexpr std::array<int, 2> sizes{16, 64};
/// Texels that ties of rounding may decide either way.
constexpr double ties = 1e-3;

/// The room with a rug of bumps, 2 * `across`^2 triangles.
Scene room_with_rug(int across) {
    Scene scene = furnished_room();
    std::vector<glm::dvec3> corners;
    const auto point = [&](int i, int k) {
        const double u = static_cast<double>(i) / across, v = static_cast<double>(k) / across;
        return glm::dvec3(0.1 + 0.4 * u, 0.1 + 0.05 * std::sin(20 * u) * std::sin(20 * v), 0.1 + v);
    };
    for (int i = 0; i < across; ++i)
        for (int k = 0; k < across; ++k)
            corners.insert(corners.end(),
                           {point(i, k), point(i, k + 1), point(i + 1, k + 1), point(i, k), point(i + 1, k + 1), point(i + 1, k)});
    add_triangles(scene, corners, {glm::vec3(0.4F)});
    return scene;
}

/// Points in the air: half-way between the middle of the scene and its triangles.
std::vector<float4> centres_in(const FlatScene& flat) {
    std::vector<glm::vec3> points;
    glm::vec3 middle(0);
    for (int i = 0; i < maps_of_batch; ++i) {
        const Triangle& t = flat.triangles[static_cast<std::size_t>(i) * flat.triangles.size() / maps_of_batch];
        points.push_back((glm::vec3(t.v0) + glm::vec3(t.v1) + glm::vec3(t.v2)) / 3.0F);
        middle += points.back() / static_cast<float>(maps_of_batch);
    }
    std::vector<float4> centres;
    centres.reserve(points.size());
    for (const glm::vec3& p : points) centres.emplace_back(0.5F * (p + middle), 0.0F);
    return centres;
}

void make_maps(VisibilityPath path, Kernels& kernels, const DeviceScene& scene, GeometryMaps& maps) {
    switch (path) {
        case VisibilityPath::rasterize:
            return rasterize_octahedral(kernels, scene, maps, 0, maps.count);
        case VisibilityPath::clusters:
            return rasterize_clusters(kernels, scene, maps, 0, maps.count);
        case VisibilityPath::trace:
            return trace_maps(kernels, scene, maps, 0, maps.count);
    }
}

double device_seconds(Device& device) {
    double sum = 0;
    for (const auto& [kernel, times] : device.kernel_times()) sum += times.device_seconds;
    return sum;
}

bool same_maps(const std::vector<Hit>& maps, const std::vector<Hit>& expected) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < maps.size(); ++i) different += maps[i].triangle != expected[i].triangle ? 1 : 0;
    return static_cast<double>(different) <= ties * static_cast<double>(maps.size());
}

MapTimes measure_batch(Kernels& kernels, const DeviceScene& scene, const std::vector<float4>& centres, int size, int rounds,
                       const std::function<void()>& go_on) {
    MapTimes times{scene.triangle_count, {maps_of_batch, size}, {}};
    GeometryMaps maps(kernels.device(), centres, MapShape(PENCIL_MAP_OCTAHEDRAL, size), "tuning");
    std::vector<Hit> expected;
    for (const VisibilityPath path : visibility_paths) {
        make_maps(path, kernels, scene, maps);
        const std::vector<Hit> hits = maps.hits.read();
        if (path == VisibilityPath::rasterize) expected = hits;
        times.seconds[static_cast<std::size_t>(path)] = std::numeric_limits<double>::infinity();
        if (!same_maps(hits, expected)) continue;
        for (int round = 0; round < rounds; ++round) {
            go_on();
            const double before = device_seconds(*kernels.device());
            make_maps(path, kernels, scene, maps);
            double& least = times.seconds[static_cast<std::size_t>(path)];
            least = std::min(least, device_seconds(*kernels.device()) - before);
        }
    }
    return times;
}

/// The power of the root of 2 next to it: factors a little apart are the same.
double rounded(double factor) { return std::exp2(std::round(2 * std::log2(factor)) / 2); }

MapSpeed speed_of(int compute_units, const MapCosts& costs) {
    MapSpeed speed(compute_units);
    speed.costs = costs;
    return speed;
}

}  // namespace

std::vector<MapTimes> measure_maps(const std::shared_ptr<Device>& device, int rounds, const std::function<void()>& go_on) {
    std::vector<MapTimes> times;
    for (const int across : {2, 48}) {
        const Scene scene = room_with_rug(across);
        const std::vector<LightForm> forms = choose_light_forms(scene, false, false);
        const FlatScene flat = flatten(scene, forms, 1, 1, light_unit(scene));
        Kernels kernels(device, scene_features(flat, 1, false));
        const DeviceScene on_device(device, flat, build_bvh(flat.triangles), cluster_triangles(flat.triangles));
        for (const int size : sizes) times.push_back(measure_batch(kernels, on_device, centres_in(flat), size, rounds, go_on));
    }
    return times;
}

MapCosts fitted_costs(const std::vector<MapTimes>& times, int compute_units) {
    MapCosts costs{};
    for (std::size_t path = 0; path < costs.size(); ++path) {
        double sum = 0;
        for (const MapTimes& t : times)
            sum += std::log2(t.seconds[path] / maps_seconds(visibility_paths[path], t.triangles, t.batch, compute_units));
        const double mean = rounded(std::exp2(sum / static_cast<double>(times.size())));
        costs[path] = mean < costs_of_wrong_path ? std::max(mean, 1 / costs_of_wrong_path) : costs_of_wrong_path;
    }
    return costs;
}

double seconds_of_choices(const std::vector<MapTimes>& times, int compute_units, const MapCosts& costs) {
    double sum = 0;
    for (const MapTimes& t : times)
        sum += t.seconds[static_cast<std::size_t>(choose_path(t.triangles, t.batch, speed_of(compute_units, costs), {true, true}))];
    return sum;
}

MapCosts choose_costs(const std::vector<MapTimes>& times, int compute_units, const MapCosts& stored, std::vector<TuneRow>& rows) {
    const MapCosts generic{1, 1, 1}, fitted = fitted_costs(times, compute_units);
    const double plain = seconds_of_choices(times, compute_units, generic);
    const auto ratio_of = [&](const MapCosts& costs) { return seconds_of_choices(times, compute_units, costs) / plain; };
    MapCosts chosen = generic;
    double ratio = 1;
    if (stored != generic && ratio_of(stored) < 1 - stay_margin) {
        chosen = stored;
        ratio = ratio_of(stored);
    }
    if (ratio_of(fitted) < (1 - win_margin) * ratio) chosen = fitted;
    const auto text = [](const MapCosts& costs) { return fmt::format("costs {:.2g}, {:.2g}, {:.2g}", costs[0], costs[1], costs[2]); };
    rows.push_back({"geometry maps", text(fitted), ratio_of(fitted), chosen == fitted ? "kept" : ""});
    if (stored != generic && stored != fitted)
        rows.push_back({"geometry maps", text(stored), ratio_of(stored), chosen == stored ? "kept" : ""});
    return chosen;
}

}  // namespace pencil
