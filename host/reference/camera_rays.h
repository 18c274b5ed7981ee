// Camera rays of a pixel, distributed as its reconstruction filter, and over the lens if there is one.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "reference/filter_sampler.h"
#include "reference/ray_scene.h"
#include "reference/sampler.h"

namespace pencil {

class CameraRays {
public:
    /// `width` and `height`: of the image [pixels], which is the film, or the part of it that the sensor's crop window says.
    CameraRays(const PerspectiveSensor& sensor, const RayScene& scene, int width, int height);

    struct Sample {
        Ray ray;
        float weight = 0;    // of its radiance; the mean over samples is the filtered pixel
        bool meets = false;  // false: the ray passes by the scene's triangles
    };
    /// Of a pixel of the image. Samples that would fall outside the film are not made: the filter is normalised over what it covers of it.
    Sample sample(int x, int y, Sampler& sampler) const;

private:
    FilterSampler filter_;
    std::vector<FilterSampler::Range> columns_, rows_;  // the filter of a pixel as far as it lies within the film
    // The ray of (px, py): from eye, to corner + px step_x + py step_y at unit depth; if parallel, from there into the direction `forward`.
    glm::dvec3 eye_, corner_, step_x_, step_y_, forward_;
    glm::dvec3 lens_x_{0.0}, lens_y_{0.0};  // radii of the lens [scene units]; zero: a pinhole
    glm::dvec3 low_, high_;
    double near_, far_, inverse_focus_ = 0;
    bool parallel_;
};

}  // namespace pencil
