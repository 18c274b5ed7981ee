// Where pencils of the world set gather from. A pencil stands for light at many places, and what it should know is the mean over those, not
// the light at its centre: where irradiance is curved the two differ, always to the same side, and reflection after reflection loses or
// gains. So each gathers from points that read it, drawn in proportion to their weight in the image: then the residual of the solution is
// orthogonal to the importance of each pencil, and the mean of the image has no error of interpolation (Petrov-Galerkin).
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "surface/seen_points.h"

namespace pencil {

/// Which pencils points read, from link_surfels.
struct PointLinks {
    std::vector<glm::ivec4> pencils;  // -1: none
    std::vector<float4> weights;

    /// Calls visit(pencil, weight) for the pencils that point i reads.
    template <typename Visit>
    void each(std::size_t i, Visit visit) const {
        for (int k = 0; k < 4; ++k)
            if (pencils[i][k] >= 0 && weights[i][k] > 0) visit(static_cast<std::size_t>(pencils[i][k]), weights[i][k]);
    }
};

/// How much of the image's light passes each pencil, over all orders of reflection: the adjoint of transport between them. The first
/// `seeds` * `texels` points are what the film sees, the rest are what the pencils' own texels see.
std::vector<float> pencil_importance(const std::vector<SeenPoints::Point>& points, const PointLinks& links, std::size_t pencils,
                                     std::size_t seeds, std::size_t texels);

class SharedPoints {
public:
    SharedPoints() = default;
    SharedPoints(const std::vector<SeenPoints::Point>& points, const PointLinks& links, std::size_t pencils, std::size_t seeds,
                 std::size_t texels);

    /// How much of the image's light the film reads from each pencil, all orders of reflection in what it sends.
    const std::vector<float>& read_by_film() const { return read_by_film_; }

    /// `draws` points of those that read the pencil, in proportion to what the image reads through them; -1 where nothing reads it, and of
    /// pencils that are not among those.
    std::vector<int> draw(std::size_t pencil, int draws, std::uint64_t seed) const;

private:
    std::vector<std::size_t> first_;  // of each pencil's points; one more than pencils
    std::vector<int> point_;
    std::vector<float> read_by_film_;
    std::vector<float> up_to_;  // sum of the weights of the pencil's points up to and with this one
};

}  // namespace pencil
