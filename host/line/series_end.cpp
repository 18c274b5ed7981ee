#include "line/series_end.h"

#include <fmt/format.h>

namespace pencil {

namespace {

/// Orders of bounces after which the series is closed by its tail whatever the tolerance.
constexpr std::size_t most_bounces = 512;

void give_up(RenderStats& stats, const std::string& why) {
    stats.warnings.push_back(why);
    stats.converged = false;
}

}  // namespace

bool series_ended(const BounceSeries& series, double tolerance, RenderStats& stats) {
    if (series.last_share() < tolerance) return true;
    if (series.diverges()) {
        give_up(stats,
                fmt::format("each reflection is brighter than the last: the series has no sum with these weights; stopped after {}, the "
                            "image is not that of the scene",
                            series.steps()));
        return true;
    }
    if (series.steps() <= most_bounces) return false;
    give_up(stats, fmt::format("bounces do not decrease (albedo near 1 in a closed scene): stopped after {}, not converged", most_bounces));
    return true;
}

}  // namespace pencil
