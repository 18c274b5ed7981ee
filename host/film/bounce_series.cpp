#include "film/bounce_series.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pencil {

glm::dvec3 BounceSeries::sum() const { return std::accumulate(means_.begin(), means_.end(), glm::dvec3(0)); }

double BounceSeries::last_share() const {
    if (means_.empty()) return 1.0;
    const glm::dvec3 sum = this->sum();
    double share = 0;
    for (int c = 0; c < 3; ++c)
        if (sum[c] > 0) share = std::max(share, means_.back()[c] / sum[c]);
    return share;
}

bool BounceSeries::diverges() const {
    if (means_.empty()) return false;
    for (int c = 0; c < 3; ++c) {
        if (!std::isfinite(means_.back()[c])) return true;
        std::size_t grown = 0;
        for (std::size_t k = means_.size() - 1; k > 0 && means_[k - 1][c] > 0 && means_[k][c] > least_growth * means_[k - 1][c]; --k)
            ++grown;
        if (grown >= growing_steps) return true;
    }
    return false;
}

glm::dvec3 BounceSeries::ratio() const {
    glm::dvec3 r(0);
    if (means_.size() < 2) return r;
    // Shrinking sets differ from one another: the mean over two steps is steadier than the last step alone.
    const std::size_t steps = std::min<std::size_t>(2, means_.size() - 1);
    const glm::dvec3 &last = means_.back(), &first = means_[means_.size() - 1 - steps];
    for (int c = 0; c < 3; ++c)
        if (first[c] > 0) r[c] = std::min(std::pow(last[c] / first[c], 1.0 / static_cast<double>(steps)), largest_ratio);
    return r;
}

glm::dvec3 BounceSeries::tail_factor() const {
    const glm::dvec3 r = ratio();
    return r / (glm::dvec3(1.0) - r);
}

double BounceSeries::tail_share() const {
    if (means_.empty() || diverges()) return std::numeric_limits<double>::infinity();
    const glm::dvec3 tail = tail_factor() * means_.back(), whole = sum() + tail;
    double share = 0;
    for (int c = 0; c < 3; ++c)
        if (whole[c] > 0) share = std::max(share, tail[c] / whole[c]);
    return share;
}

}  // namespace pencil
