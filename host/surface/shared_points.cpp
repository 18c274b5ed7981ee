#include "surface/shared_points.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "pencils/low_discrepancy.h"

namespace pencil {

namespace {

/// Orders of reflection that importance is carried over at most, and the share of all of it at which it stops. What is left is closed as a
/// geometric series of the last order, whose distribution hardly changes by then.
constexpr int most_orders = 8;
constexpr double least_share = 0.01;
constexpr double most_ratio = 0.999;

struct Reader {
    float azimuth, weight;
    int point;
};

/// Direction from the pencil to a point in some tangent frame, as a number that grows with the angle.
float azimuth(const SurfacePencil& pencil, const glm::vec3& point) {
    const glm::vec3 n(pencil.normal), step = point - glm::vec3(pencil.position);
    const glm::vec3 t = glm::cross(n, std::abs(n.x) < 0.5F ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0)), b = glm::cross(n, t);
    const float x = glm::dot(step, t), y = glm::dot(step, b), size = std::abs(x) + std::abs(y);
    if (!(size > 0)) return 0;
    return y >= 0 ? 1 - x / size : 3 + x / size;
}

}  // namespace

std::vector<float> pencil_importance(const std::vector<SeenPoints::Point>& points, const PointLinks& links, std::size_t pencils,
                                     std::size_t seeds, std::size_t texels) {
    std::vector<float> order(pencils, 0.0F), next, sum;
    const auto carry = [&](std::size_t point, float importance, std::vector<float>& to) {
        links.each(point, [&](std::size_t pencil, float weight) { to[pencil] += importance * points[point].albedo * weight; });
    };
    for (std::size_t i = 0; i < seeds * texels; ++i) carry(i, 1.0F, order);
    sum = order;
    double before = 0;
    for (const float w : order) before += static_cast<double>(w);
    for (int k = 1; k <= most_orders; ++k) {
        next.assign(pencils, 0.0F);
        for (std::size_t p = 0; p < pencils; ++p) {
            const float share = order[p] / static_cast<float>(texels);
            if (share > 0)
                for (std::size_t t = (seeds + p) * texels; t < (seeds + p + 1) * texels; ++t) carry(t, share, next);
        }
        order.swap(next);
        double added = 0, total = 0;
        for (std::size_t p = 0; p < pencils; ++p) {
            sum[p] += order[p];
            added += static_cast<double>(order[p]);
            total += static_cast<double>(sum[p]);
        }
        if (added <= least_share * total) break;
        const double ratio = std::min(added / before, most_ratio);
        before = added;
        if (k < most_orders) continue;
        for (std::size_t p = 0; p < pencils; ++p) sum[p] += static_cast<float>(ratio / (1 - ratio)) * order[p];
    }
    return sum;
}

SharedPoints::SharedPoints(const std::vector<SeenPoints::Point>& points, const PointLinks& links, const std::vector<SurfacePencil>& pencils,
                           std::size_t seeds, std::size_t texels)
    : first_(pencils.size() + 1, 0) {
    const std::vector<float> importance = pencil_importance(points, links, pencils.size(), seeds, texels);
    for (std::size_t i = 0; i < points.size(); ++i) links.each(i, [&](std::size_t p, float) { ++first_[p + 1]; });
    for (std::size_t p = 0; p < pencils.size(); ++p) first_[p + 1] += first_[p];
    std::vector<Reader> readers(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float read = (i < seeds * texels ? 1.0F : importance[i / texels - seeds] / static_cast<float>(texels)) * points[i].albedo;
        links.each(i, [&](std::size_t p, float weight) {
            readers[next[p]++] = {azimuth(pencils[p], points[i].position), weight * read, static_cast<int>(i)};
        });
    }
    point_.resize(readers.size());
    up_to_.resize(readers.size());
    for (std::size_t p = 0; p < pencils.size(); ++p) {
        std::sort(readers.begin() + static_cast<std::ptrdiff_t>(first_[p]), readers.begin() + static_cast<std::ptrdiff_t>(first_[p + 1]),
                  [](const Reader& a, const Reader& b) { return a.azimuth < b.azimuth; });
        float sum = 0;
        for (std::size_t at = first_[p]; at < first_[p + 1]; ++at) {
            point_[at] = readers[at].point;
            up_to_[at] = sum += readers[at].weight;
        }
    }
}

std::vector<int> SharedPoints::draw(std::size_t pencil, int draws, std::uint64_t seed) const {
    std::vector<int> drawn(static_cast<std::size_t>(draws), -1);
    if (pencil + 1 >= first_.size()) return drawn;
    const auto begin = up_to_.begin() + static_cast<std::ptrdiff_t>(first_[pencil]),
               end = up_to_.begin() + static_cast<std::ptrdiff_t>(first_[pencil + 1]);
    if (begin == end || !(*(end - 1) > 0)) return drawn;
    // Systematic: draws at equal steps of the running sum. Which of them is which is left to chance, as each looks elsewhere.
    const double start = random_unit(seed, 0, pencil);
    const auto turn = static_cast<std::size_t>(hash64(seed ^ hash64(pencil)) % static_cast<std::uint64_t>(draws));
    for (std::size_t d = 0; d < drawn.size(); ++d) {
        const auto at =
            std::upper_bound(begin, end, static_cast<float>((static_cast<double>(d) + start) / draws * static_cast<double>(*(end - 1))));
        drawn[(d + turn) % drawn.size()] = point_[static_cast<std::size_t>(std::min(at, end - 1) - up_to_.begin())];
    }
    return drawn;
}

}  // namespace pencil
