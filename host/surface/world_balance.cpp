#include "surface/world_balance.h"

#include <cmath>

#include "surface/patience.h"

namespace pencil {

void WorldBalance::end_set() {
    if (passes_ > 1 && mean_ > 0) {
        const double share = share_ / passes_;
        noise_ += share * share * squares_ / (mean_ * mean_) * rays_ / passes_;
        freedom_ += passes_ - 1;
    }
    passes_ = rays_ = mean_ = squares_ = share_ = 0;
}

void WorldBalance::add(int set, double light, double share, double rays) {
    if (set != set_) end_set();
    set_ = set;
    if (!std::isfinite(light) || !std::isfinite(share)) return;
    const double step = light - mean_;
    mean_ += step / ++passes_;
    squares_ += step * (light - mean_);
    rays_ += rays;
    share_ += share;
    last_rays_ = rays;
}

double WorldBalance::noise() const {
    WorldBalance ended = *this;
    ended.end_set();
    return ended.freedom_ > 0 ? ended.noise_ / ended.freedom_ : 0;
}

/// The least of (weight noise / W + rest) (W + film_rays) over W. The mean is to be known mean_share times as well as pixels: so much more it weighs.
double WorldBalance::rays(double film_rays, double pixel, double mean) const {
    constexpr double weight = 1 / (mean_share * mean_share);
    // No more of the mean's noise than there is: some of what counts as the world's light comes by other ways.
    const double own = std::min(noise(), mean * last_rays_), now = last_rays_ > 0 ? own / last_rays_ : 0;
    const double rest = pixel + weight * std::max(mean - now, 0.0);
    return rest > 0 ? std::sqrt(weight * own * film_rays / rest) : 0;
}

}  // namespace pencil
