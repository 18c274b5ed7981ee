// Convergence of the bounce series: when to stop, what is left, and the geometric tail that closes it (pure arithmetic, no device).
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace pencil {

class BounceSeries {
public:
    /// Mean radiance of the maps that carry the next order of bounces.
    void add(const glm::dvec3& mean) { means_.push_back(mean); }

    std::size_t steps() const { return means_.size(); }
    /// The last order relative to the sum, largest channel; 1 before anything was added, 0 if there is no light.
    double last_share() const;
    /// True if a channel has grown growing_steps times in a row, or is no number: the series has no sum. Light that first has to come out
    /// of hidden places grows for a few steps, too, but not for so many.
    bool diverges() const;
    /// Ratio of successive orders per channel over the last two steps, below largest_ratio.
    glm::dvec3 ratio() const;
    /// Sum of all orders that follow the last, relative to the last: r / (1 - r).
    glm::dvec3 tail_factor() const;
    /// That, relative to the sum with it, largest channel.
    double tail_share() const;

    static constexpr double largest_ratio = 0.999;
    static constexpr std::size_t growing_steps = 6;
    static constexpr double least_growth = 1.01;

private:
    glm::dvec3 sum() const;

    std::vector<glm::dvec3> means_;
};

}  // namespace pencil
