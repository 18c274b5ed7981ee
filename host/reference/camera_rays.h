// Camera rays of a pixel, distributed as its reconstruction filter.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "reference/filter_sampler.h"
#include "reference/ray_scene.h"

namespace pencil {

class CameraRays {
public:
    CameraRays(const PerspectiveSensor& sensor, const RayScene& scene, int width, int height);

    struct Sample {
        Ray ray;
        float weight = 0;    // of its radiance; the mean over samples is the filtered pixel
        bool meets = false;  // false: the ray passes by the scene
    };
    /// `u` in [0, 1)^2. Samples that would fall outside the film are not made: the filter is normalised over what it covers of the film.
    Sample sample(int x, int y, const glm::dvec2& u) const;

private:
    FilterSampler filter_;
    std::vector<FilterSampler::Range> columns_, rows_;  // the filter of a pixel as far as it lies within the film
    glm::dvec3 eye_, corner_, step_x_, step_y_;         // the ray of (px, py) is eye + t (corner + px step_x + py step_y), t the depth
    glm::dvec3 low_, high_;
    double near_, far_;
};

}  // namespace pencil
