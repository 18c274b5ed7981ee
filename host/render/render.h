// The product's main job: a scene and options in, layers out. Everything between runs in kernels.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cl/device.h"
#include "options/layer.h"
#include "scene/scene.h"

namespace pencil {

enum class Method { line, surface };
enum class Initial { direct, emission, automatic };
enum class Placement { random, lds, near_surface, light_rays, camera_rays, profile };
enum class Weights { dpdf, voronoi, analytic, thesis };
enum class Iterate { sets, fixed };

struct RenderOptions {
    Method method = Method::line;
    int pencils = 128;   // line: of the first set; surface: of the world set of the first pass
    double decay = 0.7;  // size of the next pencil set relative to the last
    int bounces = -1;    // reflections at most, direct light included; -1: until the tolerance
    int map = 64;        // octahedral tile size, a multiple of 8 [texels]
    int light_samples = 64;
    Initial initial = Initial::automatic;
    std::vector<Placement> placement{Placement::lds};  // a mixture: in turn
    Weights weights = Weights::dpdf;
    Iterate iterate = Iterate::sets;
    double seconds = 0;          // surface: passes until then, 0: until target_error
    double target_error = 1e-3;  // surface: estimated relMSE at which to stop
    double tolerance = 1e-3;     // of the radiance a bounce adds, relative to the sum
    int width = 0, height = 0;   // 0: the scene's film size
    std::uint64_t seed = 0;
    int film_samples = 16;  // visibility samples per pixel, 1 to 64
};

/// As many as a first picture needs.
inline int default_pencils(Method method) { return method == Method::line ? 128 : 800; }

struct StageTime {
    std::string name;
    double wall_seconds = 0;
    double device_seconds = 0;
    int launches = 0;
    std::map<std::string, LaunchTimes> kernels;  // the same, by launch description
};

/// What one reflection added to the image.
struct BounceReport {
    int order = 0;                  // 1: direct light
    int pencils = 0;                // size of the set that carried it, 0 if none did
    glm::dvec3 mean{0};             // over the film, of the radiance added
    double projection_seconds = 0;  // device time of the projection-scatter of that set
};

struct RenderStats {
    std::vector<StageTime> stages;  // in order of execution; kernel builds are a stage of their own
    std::vector<BounceReport> bounces;
    double residual = 0;  // estimated radiance of the bounces that were not computed, relative to the image's mean
    int passes = 0;       // images averaged, surface method
    std::uint64_t world_pencils = 0, film_pencils = 0;  // of all passes
    double estimated_error = 0;                         // relMSE of the beauty, from the spread of the passes; infinite for one pass
    bool tail_closed = false;                           // the residual was added as a geometric tail
    std::uint64_t device_peak_bytes = 0;
    std::uint64_t triangles = 0, film_surfels = 0;
    std::uint64_t blind_surfels = 0;   // film surfels that no pencil of the first set sees
    std::vector<std::string> explain;  // decisions and what was left out, one sentence each
    std::vector<std::string> warnings;
};

struct RenderResult {
    int width = 0, height = 0;
    std::vector<Layer> layers;  // beauty first
    RenderStats stats;
    bool interrupted = false;  // stopped early: the layers hold what was finished
};

/// Called between launches; `fraction` in [0, 1]. Return false to stop early.
using Progress = std::function<bool(const std::string& stage, double fraction)>;

/// `aovs`: layers wanted besides the beauty ("emission", "direct", "bounces", "albedo", "normal", "depth", "position").
RenderResult render(const Scene& scene, const RenderOptions& options, const std::vector<std::string>& aovs, std::shared_ptr<Device> device,
                    const Progress& progress = {});

}  // namespace pencil
