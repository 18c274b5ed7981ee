// Sums over the camera paths of each pixel, and the layers that become of them.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "reference/path.h"
#include "reference/path_tracer.h"

namespace pencil {

/// Samples come in sets: within one they are stratified together, two are independent. The variance is estimated between sets. Different
/// pixels may be changed by different threads.
class FilmSums {
public:
    FilmSums(int width, int height, const ReferenceOptions& options);

    void add(std::size_t pixel, const PathSums& paths, const SurfaceSums& surfaces);
    /// The samples since the last call, `samples` of them, were a set.
    void end_set(std::size_t pixel, int samples);

    /// Estimated relMSE of the beauty, from the spread of sets; infinite if a pixel has fewer than two.
    double relative_mean_square_error(const std::vector<int>& samples, const std::vector<int>& sets) const;

    /// Beauty first. `samples`: of each pixel; `sets`: ended sets of each pixel.
    std::vector<Layer> layers(const std::vector<int>& samples, const std::vector<int>& sets, const RayScene& scene,
                              const glm::dvec3& eye) const;

private:
    void add_light_layers(const std::vector<int>& samples, std::vector<Layer>& layers) const;
    void add_surface_layers(const std::vector<int>& samples, const RayScene& scene, const glm::dvec3& eye,
                            std::vector<Layer>& layers) const;
    glm::dvec3 variance(std::size_t pixel, int samples, int sets) const;

    int first_order_;  // 1 of a field, which holds reflected light alone
    int max_depth_;
    bool variance_;
    std::vector<glm::dvec3> total_;
    std::vector<glm::dvec3> ended_, squares_;      // of ended sets: their sum, and the sum of (sum of a set)^2 / its samples; empty for
                                                   // a field whose variance nobody asks for
    std::vector<std::vector<glm::dvec3>> orders_;  // as PathSums::radiance, empty if not wanted
    std::vector<SurfaceSums> surfaces_;
};

}  // namespace pencil
