#include "line/placement/ray_candidates.h"

#include <fmt/format.h>

#include <algorithm>

#include "line/placement/trace_probing_rays.h"
#include "pencils/light_samples.h"
#include "pencils/place_pencils.h"

namespace pencil {

namespace {

/// Points that light rays start from.
constexpr int light_starts = 256;

double largest_extent(const FlatScene& flat) {
    const glm::dvec3 extent = flat.high - flat.low;
    return std::max({extent.x, extent.y, extent.z});
}

}  // namespace

ProbingRule near_surface_rule(const PlacementScene& scene) {
    const FlatScene& flat = scene.flat;
    return {"near-surface", "no surface",
            [&flat](const ProbingStream& stream, int first, int count) { return surface_rays(flat, stream, first, count); },
            log_uniform_distance, false};
}

/// All emitters start rays, whatever form their light enters in.
ProbingRule light_rays_rule(const PlacementScene& scene) {
    const std::vector<LightForm> samples(scene.scene.shapes.size(), LightForm::samples);
    std::vector<LightSample> lights = sample_lights(scene.scene, scene.flat, samples, light_starts, scene.seed);
    return {"light-rays", "no light",
            [lights](const ProbingStream& stream, int first, int count) { return light_rays(lights, stream, first, count); },
            uniform_distance, true};
}

ProbingRule camera_rays_rule(const PlacementScene& scene) {
    const Camera camera = scene.flat.camera;
    return {"camera-rays", "no film",
            [camera](const ProbingStream& stream, int first, int count) { return camera_rays(camera, stream, first, count); },
            uniform_distance, true};
}

/// Paths go on from where those of the last set ended; where nothing reflects, they begin again.
std::vector<ProbingRay> RayCandidates::rays(const CandidateQuery& query) {
    const ProbingStream stream{scene_.seed, static_cast<std::uint64_t>(placement_), static_cast<std::uint64_t>(query.set)};
    const auto last = ends_.find(query.set - 1);
    if (rule_.continued && last != ends_.end()) {
        std::vector<ProbingRay> continued = continued_rays(last->second, stream, query.first, query.count);
        if (!continued.empty()) return continued;
    }
    return rule_.start(stream, query.first, query.count);
}

std::vector<float4> RayCandidates::place(const CandidateQuery& query) {
    // What has no free segment lies in the box instead.
    std::vector<float4> centres = place_pencils(scene_.flat, Sequence::low_discrepancy, query.first, query.count, query.set, scene_.seed);
    const std::vector<ProbingRay> probing = rays(query);
    const std::vector<ProbingHit> hits = trace_probing_rays(scene_.kernels, scene_.device_scene, probing);
    placed_ += query.count;
    in_box_ += query.count - static_cast<int>(probing.size());
    for (std::size_t i = 0; i < probing.size(); ++i) {
        const ProbingRay& ray = probing[i];
        const Segment segment = free_segment(scene_.flat, ray, hits[i].distance);
        if (segment.low < segment.high) {
            const double t = rule_.distance(segment, ray.along, largest_extent(scene_.flat));
            centres[i] = float4(glm::vec3(ray.origin + t * ray.direction), 0.0F);
        } else {
            ++in_box_;
        }
    }
    if (rule_.continued) {
        std::vector<ProbingHit>& ends = ends_[query.set];
        ends.insert(ends.end(), hits.begin(), hits.end());
    }
    return centres;
}

std::string RayCandidates::describe() const {
    if (in_box_ == 0) return rule_.name;
    if (in_box_ == placed_) return rule_.name + " (" + rule_.nothing + ": lds instead)";
    return fmt::format("{} ({} of {} rays have no free segment: lds instead)", rule_.name, in_box_, placed_);
}

}  // namespace pencil
