#include "converge/run_plan.h"

#include <algorithm>

#include "converge/methods.h"

namespace pencil {
namespace {

constexpr int most_budgets = 64;
constexpr double first_growth = 1.5;  // of time from the first to the second step, when nothing is known yet
constexpr double least_growth = 1.0, most_growth = 4.0;
constexpr double rounding = 1e-9;
constexpr double most_excess = 3;  // of the last run's time over the longest that was asked for
constexpr double ladder_sum = 4;   // time of a whole ladder relative to its longest run

}  // namespace

const RunPoint* find_point(const std::vector<RunPoint>& points, const std::string& method, int budget, std::uint64_t seed) {
    const auto found = std::find_if(points.begin(), points.end(), [&](const RunPoint& point) {
        return point.method == method && point.budget == budget && point.seed == seed;
    });
    return found == points.end() ? nullptr : &*found;
}

bool RunPlan::exists(const std::string& method, int budget, const std::vector<RunPoint>& done) const {
    const auto end = ends_.find(method);
    if (end != ends_.end() && budget >= end->second) return false;
    if (method == path_tracer_name) return budget == 0 || path_tracer_seconds(budget) <= longest_ * (1 + rounding);
    const RunPoint* last = find_point(done, method, budget - 1, 0);
    if (budget == 0 || last == nullptr) return budget == 0;
    const RunPoint* before = find_point(done, method, budget - 2, 0);
    const double ratio = before == nullptr ? first_growth : last->seconds / before->seconds;
    return last->seconds < longest_ && last->seconds * std::clamp(ratio, least_growth, most_growth) <= most_excess * longest_;
}

std::optional<Task> RunPlan::next(const std::vector<RunPoint>& done) const {
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(seeds_); ++seed) {
        for (int budget = 0; budget < most_budgets; ++budget) {
            for (const std::string& method : methods_)
                if (find_point(done, method, budget, seed) == nullptr && exists(method, budget, done)) return Task{method, budget, seed};
        }
    }
    return {};
}

double RunPlan::expected_seconds(const std::vector<RunPoint>& done) const {
    double expected = 0;
    for (const std::string& method : methods_) {
        double ladder = 0, finished = 0;
        int steps = 0;
        for (const RunPoint* point = find_point(done, method, 0, 0); point != nullptr; point = find_point(done, method, ++steps, 0))
            ladder += point->seconds;
        if (exists(method, steps, done)) ladder = std::max(ladder, ladder_sum * longest_);  // not complete
        for (const RunPoint& point : done)
            finished += point.method == method && point.seed < static_cast<std::uint64_t>(seeds_) ? point.seconds : 0;
        expected += std::max(0.0, seeds_ * ladder - finished);
    }
    return expected;
}

}  // namespace pencil
