// Probing rays (thesis 6.2.2): rays on whose free segments centres of projection are placed, from surfaces, lights and the film, and
// continued where they end. Nothing here traces; coordinates are scene units.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "pencils/flat_scene.h"
#include "shared/light.h"

namespace pencil {

struct ProbingRay {
    glm::dvec3 origin{0.0}, direction{0.0};  // of unit length
    double along = 0;                        // in [0, 1): which point of its free segment is the centre
    double longest = std::numeric_limits<double>::infinity();
    int plane = -1;  // that it starts on
};

/// What a ray meets, and the weight with which it is continued from there.
struct ProbingHit {
    glm::dvec3 position{0.0}, normal{0.0};  // geometric normal on the side that was met
    glm::dvec3 albedo{0.0};                 // of that side
    double distance = std::numeric_limits<double>::infinity();
    int plane = -1;
};

/// Names the random numbers of one set of one placement.
struct ProbingStream {
    std::uint64_t seed = 0, placement = 0, set = 0;
};

/// Rays first .. first + count from points uniform over the area of all sides that reflect or emit (over all triangles if none does), along
/// the normals of those sides; of two-sided walls of the scene's box the inner side. Empty if there are no triangles.
std::vector<ProbingRay> surface_rays(const FlatScene& flat, const ProbingStream& stream, int first, int count);

/// From light samples chosen by power: cosine-distributed from emitters, in all directions from point lights. Empty without power.
std::vector<ProbingRay> light_rays(const std::vector<LightSample>& samples, const ProbingStream& stream, int first, int count);

/// Through points uniform over the film, from the near to the far clipping distance.
std::vector<ProbingRay> camera_rays(const Camera& camera, const ProbingStream& stream, int first, int count);

/// Diffuse reflections of rays that ended at `hits`, chosen by the luminance of the albedo: as Russian roulette continues paths, but
/// with a fixed number of survivors. Empty if nothing reflects.
std::vector<ProbingRay> continued_rays(const std::vector<ProbingHit>& hits, const ProbingStream& stream, int first, int count);

/// The part of a ray inside the scene's box up to `distance`; an empty one has low >= high.
struct Segment {
    double low = 0, high = 0;
};
Segment free_segment(const FlatScene& flat, const ProbingRay& ray, double distance);

/// Distances from the start of a ray, for `u` in [0, 1): uniform over the segment, or uniform in the logarithm from nearest_surface (of
/// the scene's largest extent) to the same distance from the segment's other end; the middle of segments too short for that.
double uniform_distance(const Segment& segment, double u, double extent);
double log_uniform_distance(const Segment& segment, double u, double extent);

/// Distance from surfaces at which near-surface centres begin, relative to the scene's largest extent.
constexpr double nearest_surface = 2e-3;

}  // namespace pencil
