// Light from all around, infinitely far away.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"

namespace pencil {

class EnvironmentLight {
public:
    /// `light`: unit of radiance.
    explicit EnvironmentLight(const Environment& environment, double light = 1.0);

    struct Sample {
        glm::vec3 direction;  // unit, to the light
        glm::vec3 radiance;
        float density;  // [1/sr]
    };
    /// `u` in [0, 1)^2.
    Sample sample(const glm::dvec2& u) const;
    /// From a unit direction.
    glm::vec3 radiance(const glm::vec3& direction) const;
    /// Density of `sample`, of a unit direction [1/sr].
    float density(const glm::vec3& direction) const;

    /// Integral of the mean of the channels over all directions [W m^-2].
    double flux() const { return flux_; }

private:
    struct Place {
        int x, y;     // cell
        double s, t;  // in the cell, in [0, 1]
    };
    Place place(const glm::dvec3& local) const;
    const glm::vec3& texel(int x, int y) const;
    glm::vec3 value(const Place& place) const;
    float cell_density(int x, int y) const;

    const Environment& environment_;
    glm::vec3 radiance_;  // factor of the map, or constant
    glm::dmat3 to_local_;
    int rows_ = 0;  // of cells: between the centres of texels, and the poles lie on the first and the last row of texels (Mitsuba)
    std::vector<float> cumulative_;   // in each row of cells, up to and with a cell; 1 at its end
    std::vector<double> rows_up_to_;  // all rows up to and with one; 1 at the end
    double flux_ = 0;
};

}  // namespace pencil
