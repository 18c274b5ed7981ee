// Which run comes next. The plan is a function of the finished runs alone, so that an interrupted experiment goes on where it stopped.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "converge/points.h"

namespace pencil {

struct Task {
    std::string method;
    int budget = 0;
    std::uint64_t seed = 0;
};

class RunPlan {
public:
    /// Every method with seeds 0 to `seeds` - 1. A ladder ends with its first run of at least `longest` seconds, so that its curve covers
    /// that time, or before a run of three times as long.
    RunPlan(std::vector<std::string> methods, int seeds, double longest) : methods_(std::move(methods)), seeds_(seeds), longest_(longest) {}

    /// The first run that is missing: all methods and budgets of a seed before the next seed, so that an early end leaves whole curves.
    /// Seed 0 finds where a method's ladder ends; the other seeds follow it.
    std::optional<Task> next(const std::vector<RunPoint>& done) const;

    /// The method's ladder ends below `budget`: it does not fit into memory.
    void end_ladder(const std::string& method, int budget) { ends_[method] = budget; }

    /// Expected time of what is missing [s]; a guess until seed 0 is done.
    double expected_seconds(const std::vector<RunPoint>& done) const;

private:
    bool exists(const std::string& method, int budget, const std::vector<RunPoint>& done) const;

    std::vector<std::string> methods_;
    int seeds_;
    double longest_;
    std::map<std::string, int> ends_;
};

/// The run of this method, budget and seed, or null.
const RunPoint* find_point(const std::vector<RunPoint>& points, const std::string& method, int budget, std::uint64_t seed);

}  // namespace pencil
