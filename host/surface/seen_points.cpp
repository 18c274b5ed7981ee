#include "surface/seen_points.h"

#include <glm/gtx/component_wise.hpp>

namespace pencil {

void SeenPoints::read_pencils(const SurfacePencils& set) {
    texels_ = static_cast<std::size_t>(set.texels());
    if (&set != last_set_) before_ = pencils_.size();
    last_set_ = &set;
    const std::size_t known = pencils_.size() - before_;
    const std::vector<SurfacePencil> more = set.data.read(known, static_cast<std::size_t>(set.count) - known);
    pencils_.insert(pencils_.end(), more.begin(), more.end());
}

void SeenPoints::read_points(const Surfels& surfels) {
    static_assert(SURFEL_X == 0 && SURFEL_NX == 3 && SURFEL_ALBEDO_B == 9, "what is read are the first fields");
    const std::size_t first = points_.size(), count = static_cast<std::size_t>(surfels.count) - first;
    const std::vector<float> field = surfels.data.read_rows(first, static_cast<std::size_t>(surfels.capacity), SURFEL_ALBEDO_B + 1, count);
    const auto vector = [&](std::size_t f, std::size_t i) {
        return glm::vec3(field[f * count + i], field[(f + 1) * count + i], field[(f + 2) * count + i]);
    };
    points_.reserve(first + count);
    for (std::size_t i = 0; i < count; ++i)
        points_.push_back({vector(SURFEL_X, i), vector(SURFEL_NX, i), glm::compMax(vector(SURFEL_ALBEDO_R, i))});
}

}  // namespace pencil
