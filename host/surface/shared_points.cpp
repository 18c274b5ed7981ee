#include "surface/shared_points.h"

#include <algorithm>

#include "pencils/low_discrepancy.h"

namespace pencil {

namespace {

/// Orders of reflection that importance is carried over at most, and the share of all of it at which it stops. What is left is closed as a
/// geometric series of the last order, whose distribution hardly changes by then.
constexpr int most_orders = 3;
constexpr double least_share = 0.01;
constexpr double most_ratio = 0.999;

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

SharedPoints::SharedPoints(const std::vector<SeenPoints::Point>& points, const PointLinks& links, std::size_t pencils, std::size_t seeds,
                           std::size_t texels)
    : first_(pencils + 1, 0), read_by_film_(pencils, 0.0F) {
    const std::vector<float> importance = pencil_importance(points, links, pencils, seeds, texels);
    for (std::size_t i = 0; i < points.size(); ++i) links.each(i, [&](std::size_t p, float) { ++first_[p + 1]; });
    for (std::size_t p = 0; p < pencils; ++p) first_[p + 1] += first_[p];
    point_.resize(first_.back());
    up_to_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    std::vector<float> sum(pencils, 0.0F);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float read = (i < seeds * texels ? 1.0F : importance[i / texels - seeds] / static_cast<float>(texels)) * points[i].albedo;
        links.each(i, [&](std::size_t p, float weight) {
            const std::size_t at = next[p]++;
            point_[at] = static_cast<int>(i);
            up_to_[at] = sum[p] += weight * read;
            if (i < seeds * texels) read_by_film_[p] += weight * read;
        });
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
