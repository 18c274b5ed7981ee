#include "surface/patience.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pencil {

namespace {

/// A target that is never met ends here.
constexpr double most_work = 256;
/// But not for ever: where it takes more, it is said how well it is known.
constexpr double mean_work = 128;
/// From so much work on, an error that twice the passes do not lower to this share does not fall any more.
constexpr double steady_work = 64;
constexpr double falling_share = 0.85;
/// And from so many on where it is surely so many times what was asked for: that is no matter of patience.
constexpr double hopeless_work = 16;
constexpr double hopeless = 100;
/// The mean is known well where its error is this share of what is asked for.
constexpr double well_known = 0.7;

}  // namespace

/// Asked after every pass, few passes agree by chance sooner or later: they have to do so twice, unless they do so well.
bool Patience::knows_the_mean(const PassesSoFar& so_far) {
    const double share = mean_share * std::sqrt(target_), wanted = std::clamp(usual_mean_error, share / 2, share);
    const CertifiedError& certified = so_far.certified;
    const bool contradicted = certified.points > 1 && std::abs(certified.mean_bias) > std::max(2 * certified.mean_error, wanted);
    const double before = known_to_;
    known_to_ = contradicted ? std::numeric_limits<double>::infinity() : so_far.mean_error;
    return so_far.work >= mean_work || (known_to_ <= wanted && std::min(before, known_to_ / well_known) <= wanted);
}

Patience::Answer Patience::ask(const PassesSoFar& so_far) {
    const auto& [passes, work, error, sure_error, mean_error, certified] = so_far;
    if (passes >= 2 && !std::isfinite(error)) return {true, "the image holds values that are not finite: stopped, the error is not known"};
    const bool knows = knows_the_mean(so_far);
    if (passes >= least_passes && error <= target_ && knows) return {true, {}};
    const double patience = sure_error > hopeless * target_ ? hopeless_work : steady_work;
    const bool stuck = error > target_ && work >= patience && passes == 2 * error_passes_ && error > falling_share * last_error_ &&
                       (patience == hopeless_work || knows);
    if (stuck || work >= most_work)
        return {true,
                fmt::format("stopped {} --target-error: the estimated relMSE is {:.2g} after {} passes{}, the mean known to {:.1g} %; "
                            "--time S goes on, more --pencils may help",
                            error > target_ ? "above" : "by", error, passes, stuck ? " and falls no further" : "", 100 * mean_error)};
    if ((passes & (passes - 1)) == 0) {
        error_passes_ = passes;
        last_error_ = error;
    }
    return {false, {}};
}

}  // namespace pencil
