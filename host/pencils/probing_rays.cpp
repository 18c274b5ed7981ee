#include "pencils/probing_rays.h"

#include <algorithm>
#include <cmath>

#include "image/colour.h"
#include "pencils/low_discrepancy.h"
#include "pencils/warps.h"

namespace pencil {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// Of float coordinates of a normalised scene.
constexpr double rounding = 1e-6;

/// Points of the unit hypercube, low-discrepancy, shifted anew for each stream.
class Sequence4 {
public:
    explicit Sequence4(const ProbingStream& stream) {
        const std::uint64_t name = hash64(stream.placement + 1) ^ stream.set;
        for (int d = 0; d < 4; ++d) shift_[d] = random_unit(stream.seed, name, static_cast<std::uint64_t>(d));
    }
    glm::dvec4 operator()(int index) const { return r4_sequence(static_cast<std::uint64_t>(index) + 1, shift_); }

private:
    glm::dvec4 shift_{0.0};
};

/// Chooses by weight; what is left of the random number within the choice is as uniform as it was.
class WeightedChoice {
public:
    void add(double weight) { up_to_.push_back(total() + weight); }
    double total() const { return up_to_.empty() ? 0.0 : up_to_.back(); }

    struct Choice {
        std::size_t index;
        double left;
    };
    Choice operator()(double u) const {
        const double at = u * total();
        const auto found = std::upper_bound(up_to_.begin(), up_to_.end() - 1, at);
        const auto index = static_cast<std::size_t>(found - up_to_.begin());
        const double below = index > 0 ? up_to_[index - 1] : 0.0, weight = up_to_[index] - below;
        return {index, weight > 0 ? std::clamp((at - below) / weight, 0.0, 1.0) : 0.0};
    }

private:
    std::vector<double> up_to_;
};

/// Sides that reflect or emit: a two-sided triangle has twice the weight of a one-sided one, black walls have none.
double sides(const FlatScene& flat, const Triangle& t) {
    const Material& m = flat.materials[static_cast<std::size_t>(t.material)];
    if (luminance(glm::dvec3(m.albedo)) > 0 && m.albedo.w != 0.0F) return 2;
    return luminance(glm::dvec3(m.albedo) + glm::dvec3(m.emission)) > 0 ? 1 : 0;
}

/// False for the outer side of a wall of the scene's box, up to rounding.
bool leads_inwards(const FlatScene& flat, const ProbingRay& ray) {
    const Segment segment = free_segment(flat, ray, std::numeric_limits<double>::infinity());
    const glm::dvec3 extent = flat.high - flat.low;
    return segment.high - segment.low > 1e-5 * std::max({extent.x, extent.y, extent.z});
}

}  // namespace

std::vector<ProbingRay> surface_rays(const FlatScene& flat, const ProbingStream& stream, int first, int count) {
    WeightedChoice bright, all;
    for (const Triangle& t : flat.triangles) {
        const double area = glm::length(area_vector(t));
        bright.add(area * sides(flat, t));
        all.add(area);
    }
    const WeightedChoice& choice = bright.total() > 0 ? bright : all;
    if (choice.total() <= 0) return {};
    const Sequence4 sequence(stream);
    std::vector<ProbingRay> rays;
    for (int i = first; i < first + count; ++i) {
        const glm::dvec4 u = sequence(i);
        const auto [index, left] = choice(u.x);
        const Triangle& t = flat.triangles[index];
        const glm::dvec2 b = square_to_triangle({u.y, u.z});
        const glm::dvec3 v0(t.v0);
        const bool both = sides(flat, t) == 2, back = both && left >= 0.5;
        ProbingRay ray{v0 + b.x * (glm::dvec3(t.v1) - v0) + b.y * (glm::dvec3(t.v2) - v0), glm::normalize(area_vector(t)), u.w};
        if (back) ray.direction = -ray.direction;
        if (both && !leads_inwards(flat, ray)) ray.direction = -ray.direction;
        ray.plane = t.plane;
        rays.push_back(ray);
    }
    return rays;
}

std::vector<ProbingRay> light_rays(const std::vector<LightSample>& samples, const ProbingStream& stream, int first, int count) {
    WeightedChoice choice;
    for (const LightSample& s : samples) choice.add(luminance(glm::dvec3(s.emission)) * (s.position.w != 0.0F ? 1.0 : 4.0));  // power / pi
    if (choice.total() <= 0) return {};
    const Sequence4 sequence(stream);
    std::vector<ProbingRay> rays;
    for (int i = first; i < first + count; ++i) {
        const glm::dvec4 u = sequence(i);
        const LightSample& s = samples[choice(u.x).index];
        const bool area = s.position.w != 0.0F;
        const glm::dvec2 v(u.y, u.z);
        rays.push_back({glm::dvec3(s.position), area ? square_to_cosine(v, glm::dvec3(s.normal)) : square_to_sphere(v), u.w, infinite,
                        static_cast<int>(s.emission.w)});
    }
    return rays;
}

std::vector<ProbingRay> camera_rays(const Camera& camera, const ProbingStream& stream, int first, int count) {
    const Sequence4 sequence(stream);
    std::vector<ProbingRay> rays;
    for (int i = first; i < first + count; ++i) {
        const glm::dvec4 u = sequence(i);
        const glm::dvec3 way =
            glm::dvec3(camera.corner) + u.x * camera.width * glm::dvec3(camera.step_x) + u.y * camera.height * glm::dvec3(camera.step_y);
        const double near = static_cast<double>(camera.near_clip), far = static_cast<double>(camera.far_clip);
        rays.push_back({glm::dvec3(camera.origin) + near * way, glm::normalize(way), u.z, (far - near) * glm::length(way)});
    }
    return rays;
}

std::vector<ProbingRay> continued_rays(const std::vector<ProbingHit>& hits, const ProbingStream& stream, int first, int count) {
    WeightedChoice choice;
    for (const ProbingHit& hit : hits) choice.add(std::isfinite(hit.distance) ? luminance(hit.albedo) : 0.0);
    if (choice.total() <= 0) return {};
    const Sequence4 sequence(stream);
    std::vector<ProbingRay> rays;
    for (int i = first; i < first + count; ++i) {
        const glm::dvec4 u = sequence(i);
        const ProbingHit& hit = hits[choice(u.x).index];
        rays.push_back({hit.position, square_to_cosine({u.y, u.z}, hit.normal), u.w, infinite, hit.plane});
    }
    return rays;
}

Segment free_segment(const FlatScene& flat, const ProbingRay& ray, double distance) {
    Segment segment{0.0, std::min(distance, ray.longest)};
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0.0) {
            const bool beside = ray.origin[axis] < flat.low[axis] - rounding || ray.origin[axis] > flat.high[axis] + rounding;
            if (beside) segment.high = segment.low;
            continue;
        }
        const double a = (flat.low[axis] - ray.origin[axis]) / ray.direction[axis];
        const double b = (flat.high[axis] - ray.origin[axis]) / ray.direction[axis];
        segment.low = std::max(segment.low, std::min(a, b));
        segment.high = std::min(segment.high, std::max(a, b));
    }
    return segment;
}

double uniform_distance(const Segment& segment, double u, double) { return segment.low + u * (segment.high - segment.low); }

double log_uniform_distance(const Segment& segment, double u, double extent) {
    const double length = segment.high - segment.low, near = std::min(nearest_surface * extent, 0.5 * length), far = length - near;
    return segment.low + near * std::pow(far / near, u);
}

}  // namespace pencil
