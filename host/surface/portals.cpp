#include "surface/portals.h"

#include <algorithm>
#include <cmath>
#include <glm/gtx/norm.hpp>
#include <limits>
#include <numeric>
#include <optional>

#include "pencils/low_discrepancy.h"

namespace pencil {

namespace {

/// A ray is bright that brings so many times what its pencil's rays bring in the mean.
constexpr float bright = 6;
/// Portals are worth rays of their own where bright rays bring this share of the light,
constexpr float least_light = 0.3F;
/// enough of them that it is no chance, and each portal this share of it.
constexpr std::size_t least_rays = 24;
constexpr double least_share = 0.05;
/// Rays that are looked at, at most, and portals.
constexpr std::size_t most_rays = 2048;
constexpr std::size_t most_portals = 6;
/// Where pairs of rays come closest a portal may be: so many pairs are tried.
constexpr int pairs = 96;
/// A narrower portal is the better one if this share of the light comes through it; each step halves it, so many times.
constexpr double narrow_share = 0.75;
constexpr int steps = 4;
/// A portal's radius in terms of the root mean square distance of its rays from its centre.
constexpr float spread = 1.5F;
/// Rays from nearer than so many radii say nothing of what is narrow.
constexpr float least_distance = 3;
/// More light than if it came from everywhere alike, at least so many times as much.
constexpr double least_gain = 4;
/// Portals cost a fifth to a half of the rays of pencils: they are not worth that where less of the light comes through them.
constexpr double least_through = 0.5;

/// Along a ray, the point closest to `place`; its distance from there, infinite if the ray begins near that place or ends before it.
float distance_from(const LightRay& ray, const glm::vec3& place, float radius) {
    const float along = glm::dot(place - ray.origin, ray.direction);
    if (along < least_distance * radius || along > ray.distance + radius) return std::numeric_limits<float>::infinity();
    return glm::distance(ray.origin + along * ray.direction, place);
}

/// In the middle between two rays where they are closest.
std::optional<glm::vec3> meeting(const LightRay& a, const LightRay& b) {
    const float c = glm::dot(a.direction, b.direction), square = 1 - c * c;
    if (!(square > 1e-4F)) return {};
    const glm::vec3 step = b.origin - a.origin;
    const float da = glm::dot(step, a.direction), db = glm::dot(step, b.direction);
    const float s = (da - c * db) / square, t = (c * da - db) / square;
    if (!(s > 0) || !(t > 0)) return {};
    return 0.5F * (a.origin + s * a.direction + b.origin + t * b.direction);
}

/// Directions in which surfels were seen, of scenes whose surfels hold them.
class SeenDirections {
public:
    SeenDirections(const Surfels& seen, bool outgoing) : count_(static_cast<std::size_t>(seen.count)) {
        const auto capacity = static_cast<std::size_t>(seen.capacity);
        if (outgoing) fields_ = seen.data.read_rows(SURFEL_OX * capacity, capacity, SURFEL_SHARE - SURFEL_OX + 1, count_);
    }
    /// Lobes have led the ray elsewhere.
    bool is_turned(std::size_t i) const {
        return !fields_.empty() && fields_[static_cast<std::size_t>(SURFEL_SHARE - SURFEL_OX) * count_ + i] >= 0;
    }
    /// `step`: from where the surfel was seen to it.
    glm::vec3 of(std::size_t i, const glm::vec3& step) const {
        return fields_.empty() ? glm::normalize(step) : -glm::vec3(fields_[i], fields_[count_ + i], fields_[2 * count_ + i]);
    }

private:
    std::size_t count_;
    std::vector<float> fields_;
};

class PortalFinder {
public:
    PortalFinder(std::vector<LightRay> rays, float reach) : rays_(std::move(rays)), reach_(reach) {}

    struct Portal {
        Spot spot;     // weight: in the rays' terms
        double width;  // about what share of all its directions it is to a pencil
    };

    /// The one that most light comes through, of the rays that no portal holds so far; they are then held.
    std::optional<Portal> next() {
        if (rays_.size() < least_rays) return {};
        Candidate best{};
        for (int step = 0; step <= steps; ++step) {
            const Candidate found = best_of(reach_ / static_cast<float>(1 << step));
            if (step > 0 && found.light < narrow_share * best.light) break;
            best = found;
        }
        return best.light > 0 ? std::optional<Portal>(take(best)) : std::nullopt;
    }
    double light() const {
        return std::accumulate(
            rays_.begin(), rays_.end(), 0.0, [](double sum, const LightRay& r) { return sum + static_cast<double>(r.light); });
    }

private:
    struct Candidate {
        glm::vec3 centre;
        float radius;
        double light;
    };

    const LightRay& pick(int pair, std::uint64_t which) const {
        const auto n = static_cast<double>(rays_.size());
        return rays_[std::min(static_cast<std::size_t>(n * random_unit(rays_.size(), which, static_cast<std::uint64_t>(pair))),
                              rays_.size() - 1)];
    }

    Candidate best_of(float radius) const {
        Candidate best{glm::vec3(0), radius, 0};
        for (int pair = 0; pair < pairs; ++pair) {
            const std::optional<glm::vec3> centre = meeting(pick(pair, 1), pick(pair, 2));
            if (!centre) continue;
            double light = 0;
            for (const LightRay& ray : rays_)
                if (distance_from(ray, *centre, radius) <= radius) light += static_cast<double>(ray.light);
            if (light > best.light) best = {*centre, radius, light};
        }
        return best;
    }

    /// The sphere about the rays of a candidate, in the middle of where these come closest to it.
    Portal take(const Candidate& candidate) {
        const auto held = std::stable_partition(rays_.begin(), rays_.end(), [&](const LightRay& ray) {
            return !(distance_from(ray, candidate.centre, candidate.radius) <= candidate.radius);
        });
        glm::dvec3 middle(0);
        double light = 0, emission = 0, squares = 0, width = 0;
        for (auto ray = held; ray != rays_.end(); ++ray) {
            const auto l = static_cast<double>(ray->light);
            const float along = glm::dot(candidate.centre - ray->origin, ray->direction);
            middle += l * glm::dvec3(ray->origin + along * ray->direction - candidate.centre);
            light += l;
            emission += l * static_cast<double>(ray->emission);
        }
        const glm::vec3 centre = candidate.centre + glm::vec3(middle / light);
        for (auto ray = held; ray != rays_.end(); ++ray) {
            const glm::vec3 step = centre - ray->origin, aside = step - glm::dot(step, ray->direction) * ray->direction;
            squares += static_cast<double>(ray->light * glm::length2(aside));
            width += static_cast<double>(ray->light / std::max(glm::length2(step), std::numeric_limits<float>::min()));
        }
        rays_.erase(held, rays_.end());
        const float radius = std::max(spread * static_cast<float>(std::sqrt(squares / light)), reach_ / (1 << (steps + 2)));
        return {{centre, radius, static_cast<float>(light), static_cast<float>(emission / light)},
                width / light * static_cast<double>(radius * radius)};
    }

    std::vector<LightRay> rays_;
    float reach_;
};

/// The ray ends in the spot, or comes through it.
bool holds(const Spot& spot, const LightRay& ray) {
    const float along = std::min(glm::dot(spot.centre - ray.origin, ray.direction), ray.distance);
    return along > 0 && holds(spot, ray.origin + along * ray.direction);
}

/// Some of them, evenly, if there are very many.
std::vector<LightRay> some(const std::vector<LightRay>& rays) {
    if (rays.size() <= most_rays) return rays;
    std::vector<LightRay> chosen;
    for (std::size_t k = 0; k < most_rays; ++k) chosen.push_back(rays[k * rays.size() / most_rays]);
    return chosen;
}

}  // namespace

std::vector<LightRay> light_rays(const SeenPoints& points, const Surfels& seen, bool outgoing, const std::vector<float>& emission,
                                 const std::vector<float>& light) {
    const SeenDirections directions(seen, outgoing);
    const std::size_t texels = light.size() / points.pencils().size();
    std::vector<LightRay> rays;
    for (std::size_t begin = 0; begin + texels <= light.size(); begin += texels) {
        const auto first = light.begin() + static_cast<std::ptrdiff_t>(begin), end = first + static_cast<std::ptrdiff_t>(texels);
        const float mean = std::accumulate(first, end, 0.0F) / static_cast<float>(texels);
        const float of_bright = std::accumulate(first, end, 0.0F, [&](float sum, float l) { return l > bright * mean ? sum + l : sum; });
        if (!(of_bright > least_light * mean * static_cast<float>(texels))) continue;
        const glm::vec3 origin = points.viewer(begin);
        for (std::size_t i = begin; i < begin + texels; ++i) {
            if (!(light[i] > 0) || directions.is_turned(i)) continue;
            const SeenPoints::Point& point = points.points()[i];
            const glm::vec3 step = point.position - origin;
            const float distance = glm::length2(point.normal) > 0 ? glm::length(step) : std::numeric_limits<float>::infinity();
            rays.push_back({origin, directions.of(i, step), distance, light[i] / mean, emission[i] / light[i]});
        }
    }
    return rays;
}

std::vector<Spot> find_portals(const std::vector<LightRay>& rays, float reach, const std::vector<Spot>& known) {
    double all = 0, of_bright = 0;
    std::vector<LightRay> chosen;
    for (const LightRay& ray : rays) {
        all += static_cast<double>(ray.light);
        if (!(ray.light > bright) || std::any_of(known.begin(), known.end(), [&](const Spot& s) { return holds(s, ray); })) continue;
        of_bright += static_cast<double>(ray.light);
        chosen.push_back(ray);
    }
    if (chosen.size() < least_rays || of_bright < static_cast<double>(least_light) * all) return {};
    PortalFinder finder(some(chosen), reach);
    const double scale = of_bright / finder.light() / all;
    std::vector<Spot> portals;
    double through = 0;
    for (std::size_t k = 0; k < most_portals; ++k) {
        const std::optional<PortalFinder::Portal> found = finder.next();
        if (!found) break;
        Spot spot = found->spot;
        spot.weight *= static_cast<float>(scale);
        if (!(static_cast<double>(spot.weight) > least_share * of_bright / all)) break;
        if (!(static_cast<double>(spot.weight) > least_gain * found->width)) continue;
        portals.push_back(spot);
        through += static_cast<double>(spot.weight);
    }
    return through > least_through ? portals : std::vector<Spot>();
}

}  // namespace pencil
