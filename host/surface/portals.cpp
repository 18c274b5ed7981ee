#include "surface/portals.h"

#include <algorithm>
#include <cmath>
#include <glm/gtx/norm.hpp>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

#include "pencils/low_discrepancy.h"

namespace pencil {

namespace {

// Found by trial (docs/accuracy.md).

/// A ray is bright that brings so many times what rays about its pencil bring in the mean.
constexpr double bright = 6;
/// Where pencils are lit by bright rays so that these are this share of the noise, and give their sums at least this relative variance, the light is
/// not found well; that matters if it adds so much to the mean variance of all pencils.
constexpr double least_noise = 0.5, least_variance = 0.02, least_mean_variance = 0.004;
/// Portals are worth rays of their own where bright rays are enough of them that it is no chance, and each portal is this share of the noise,
constexpr std::size_t least_rays = 24;
constexpr double least_portal_share = 0.05;
/// so many times as much as if noise came from everywhere alike,
constexpr double least_gain = 4;
/// and all are this share: they cost a fifth to a half of the rays of pencils.
constexpr double least_through = 0.3;
/// Rays that are looked at, at most, and portals.
constexpr std::size_t most_rays = 2048;
constexpr std::size_t most_portals = 6;
/// Where pairs of rays come closest a portal may be: so many pairs are tried.
constexpr int pairs = 96;
/// A narrower portal is the better one if this share of the noise comes through it; each step halves it, so many times.
constexpr double narrow_share = 0.75;
constexpr int steps = 4;
/// A portal's radius in terms of the root mean square distance of its rays from its centre.
constexpr float spread = 1.5F;
/// Rays from nearer than so many radii say nothing of what is narrow.
constexpr float least_distance = 3;

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

/// A ray of pencils that do not find their light well.
struct NoisyRay {
    const LightRay* ray;
    double noise;  // squares of what it brings, in terms of the mean about its pencil
    double share;  // of all light of all pencils, each pencil's being the same
    bool is_bright;
};

class PortalFinder {
public:
    PortalFinder(std::vector<NoisyRay> rays, float reach) : rays_(std::move(rays)), reach_(reach) {}

    struct Portal {
        Spot spot;     // weight: its share of all light
        double noise;  // that comes through it
        double width;  // about what share of all its directions it is to a pencil
    };

    /// The one that most noise comes through, of the rays that no portal holds so far; they are then held.
    std::optional<Portal> next() {
        if (rays_.size() < least_rays) return {};
        Candidate best{};
        for (int step = 0; step <= steps; ++step) {
            const Candidate found = best_of(reach_ / static_cast<float>(1 << step));
            if (step > 0 && found.noise < narrow_share * best.noise) break;
            best = found;
        }
        return best.noise > 0 ? std::optional<Portal>(take(best)) : std::nullopt;
    }

private:
    struct Candidate {
        glm::vec3 centre;
        float radius;
        double noise;
    };

    const LightRay& pick(int pair, std::uint64_t which) const {
        const auto n = static_cast<double>(rays_.size());
        const double at = n * random_unit(rays_.size(), which, static_cast<std::uint64_t>(pair));
        return *rays_[std::min(static_cast<std::size_t>(at), rays_.size() - 1)].ray;
    }

    Candidate best_of(float radius) const {
        Candidate best{glm::vec3(0), radius, 0};
        for (int pair = 0; pair < pairs; ++pair) {
            const std::optional<glm::vec3> centre = meeting(pick(pair, 1), pick(pair, 2));
            if (!centre) continue;
            double noise = 0;
            for (const NoisyRay& noisy : rays_)
                if (distance_from(*noisy.ray, *centre, radius) <= radius) noise += noisy.noise;
            if (noise > best.noise) best = {*centre, radius, noise};
        }
        return best;
    }

    /// The sphere about the rays of a candidate, in the middle of where these come closest to it.
    Portal take(const Candidate& candidate) {
        const auto held = std::stable_partition(rays_.begin(), rays_.end(), [&](const NoisyRay& noisy) {
            return !(distance_from(*noisy.ray, candidate.centre, candidate.radius) <= candidate.radius);
        });
        glm::dvec3 middle(0);
        double noise = 0, share = 0, emission = 0, squares = 0, width = 0;
        for (auto noisy = held; noisy != rays_.end(); ++noisy) {
            const LightRay& ray = *noisy->ray;
            const float along = glm::dot(candidate.centre - ray.origin, ray.direction);
            middle += noisy->noise * glm::dvec3(ray.origin + along * ray.direction - candidate.centre);
            noise += noisy->noise;
            share += noisy->share;
            emission += noisy->share * static_cast<double>(ray.emission);
        }
        const glm::vec3 centre = candidate.centre + glm::vec3(middle / noise);
        for (auto noisy = held; noisy != rays_.end(); ++noisy) {
            const LightRay& ray = *noisy->ray;
            const glm::vec3 step = centre - ray.origin, aside = step - glm::dot(step, ray.direction) * ray.direction;
            squares += noisy->noise * static_cast<double>(glm::length2(aside));
            width += noisy->noise / static_cast<double>(std::max(glm::length2(step), std::numeric_limits<float>::min()));
        }
        rays_.erase(held, rays_.end());
        const float radius = std::max(spread * static_cast<float>(std::sqrt(squares / noise)), reach_ / (1 << (steps + 2)));
        return {{centre, radius, static_cast<float>(share), static_cast<float>(emission / share)},
                noise,
                width / noise * static_cast<double>(radius * radius)};
    }

    std::vector<NoisyRay> rays_;
    float reach_;
};

/// The ray ends in the spot, or comes through it.
bool holds(const Spot& spot, const LightRay& ray) {
    const float along = std::min(glm::dot(spot.centre - ray.origin, ray.direction), ray.distance);
    return along > 0 && holds(spot, ray.origin + along * ray.direction);
}

bool holds_any(const std::vector<Spot>& known, const LightRay& ray) {
    return std::any_of(
        known.begin(), known.end(), [&](const Spot& spot) { return holds(spot, ray); });
}

/// Pencils near each other that face about the same way, as those on one side of a wall do.
struct Neighbours {
    double light = 0, rays = 0, noise = 0, bright_noise = 0;
    double mean() const { return light / rays; }
    bool find_light(double of_each) const {
        return !(bright_noise > least_noise * noise) || !(bright_noise > least_variance * rays * of_each);
    }
};

/// Which neighbourhood each pencil lies in.
class Neighbourhoods {
public:
    Neighbourhoods(const std::vector<LightRay>& rays, std::size_t of_each, float width) {
        for (std::size_t begin = 0; begin < rays.size(); begin += of_each) {
            const LightRay& first = rays[begin];
            const glm::vec3 cell = glm::floor(first.origin / width), facing = glm::round(first.normal);
            Neighbours& about = all_[{cell.x, cell.y, cell.z, facing.x, facing.y, facing.z}];
            for (std::size_t i = begin; i < begin + of_each; ++i) about.light += static_cast<double>(rays[i].light);
            about.rays += static_cast<double>(of_each);
            of_pencil_.push_back(&about);
        }
    }
    Neighbours& of(std::size_t pencil) { return *of_pencil_[pencil]; }

private:
    std::map<std::tuple<float, float, float, float, float, float>, Neighbours> all_;
    std::vector<Neighbours*> of_pencil_;
};

/// Rays of pencils that do not find their light well, but for those that spots are known for.
std::vector<NoisyRay> noisy_rays(const std::vector<LightRay>& rays, std::size_t of_each, float near, const std::vector<Spot>& known) {
    Neighbourhoods neighbourhoods(rays, of_each, near);
    std::vector<NoisyRay> noisy;
    for (std::size_t pencil = 0; pencil < rays.size() / of_each; ++pencil) {
        Neighbours& about = neighbourhoods.of(pencil);
        const auto first = rays.begin() + static_cast<std::ptrdiff_t>(pencil * of_each), end = first + static_cast<std::ptrdiff_t>(of_each);
        const double own =
            std::accumulate(first, end, 0.0, [](double sum, const LightRay& ray) { return sum + static_cast<double>(ray.light); });
        // A ray of a pencil is no brighter than all of them, by which nothing grows beyond bounds.
        const double mean = std::max(own / static_cast<double>(of_each), about.mean());
        for (auto ray = first; ray != end; ++ray) {
            if (!(ray->light > 0) || ray->turned || holds_any(known, *ray)) continue;
            const double relative = static_cast<double>(ray->light) / mean;
            about.noise += relative * relative;
            if (relative > bright) about.bright_noise += relative * relative;
            noisy.push_back({&*ray, relative * relative, relative / static_cast<double>(rays.size()), relative > bright});
        }
    }
    const auto is_found = [&](const NoisyRay& n) {
        return neighbourhoods.of(static_cast<std::size_t>(n.ray - rays.data()) / of_each).find_light(static_cast<double>(of_each));
    };
    noisy.erase(std::remove_if(noisy.begin(), noisy.end(), is_found), noisy.end());
    return noisy;
}

/// Some of them, evenly, if there are very many, each for all that it stands for.
std::vector<NoisyRay> some(const std::vector<NoisyRay>& rays) {
    if (rays.size() <= most_rays) return rays;
    const double factor = static_cast<double>(rays.size()) / most_rays;
    std::vector<NoisyRay> chosen;
    for (std::size_t k = 0; k < most_rays; ++k) {
        chosen.push_back(rays[k * rays.size() / most_rays]);
        chosen.back().noise *= factor;
        chosen.back().share *= factor;
    }
    return chosen;
}

}  // namespace

std::vector<LightRay> light_rays(const SeenPoints& points, const Surfels& seen, bool outgoing, const std::vector<float>& emission,
                                 const std::vector<float>& light) {
    const SeenDirections directions(seen, outgoing);
    const std::size_t texels = light.size() / points.pencils().size();
    std::vector<LightRay> rays;
    rays.reserve(light.size());
    for (std::size_t i = 0; i < light.size(); ++i) {
        const SeenPoints::Point& point = points.points()[i];
        const glm::vec3 origin = points.viewer(i), step = point.position - origin;
        const float distance = glm::length2(point.normal) > 0 ? glm::length(step) : std::numeric_limits<float>::infinity();
        const SurfacePencil& viewer = points.pencils()[i / texels];
        rays.push_back({origin, directions.of(i, step), glm::vec3(viewer.normal.x, viewer.normal.y, viewer.normal.z), distance, light[i],
                        light[i] > 0 ? emission[i] / light[i] : 0, directions.is_turned(i)});
    }
    return rays;
}

std::vector<Spot> find_portals(const std::vector<LightRay>& rays, int of_each, const PortalLengths& lengths,
                               const std::vector<Spot>& known) {
    if (!(lengths.near > 0) || rays.empty()) return {};
    double all = 0, of_bright = 0;
    std::vector<NoisyRay> chosen;
    for (const NoisyRay& noisy : noisy_rays(rays, static_cast<std::size_t>(of_each), lengths.near, known)) {
        all += noisy.noise;
        if (!noisy.is_bright) continue;
        of_bright += noisy.noise;
        chosen.push_back(noisy);
    }
    if (chosen.size() < least_rays || !(of_bright > least_mean_variance * static_cast<double>(rays.size()) * of_each)) return {};
    PortalFinder finder(some(chosen), lengths.widest);
    std::vector<Spot> portals;
    double through = 0;
    for (std::size_t k = 0; k < most_portals; ++k) {
        const std::optional<PortalFinder::Portal> found = finder.next();
        if (!found || !(found->noise > least_portal_share * all)) break;
        if (!(found->noise > least_gain * found->width * all)) continue;
        portals.push_back(found->spot);
        through += found->noise / all;
    }
    return through > least_through ? portals : std::vector<Spot>();
}

}  // namespace pencil
