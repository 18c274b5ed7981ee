// The experiment's book-keeping without a device: what runs next, how runs are put together, who is ahead.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "compare/metrics.h"
#include "converge/methods.h"
#include "converge/report.h"
#include "converge/run_plan.h"
#include "converge/runs.h"
#include "unit/run_points.h"

namespace pencil {
namespace {

/// Runs the plan with render times of `first` * growth^budget; the order of tasks.
std::vector<RunPoint> simulate(const RunPlan& plan, double first, double growth, std::vector<RunPoint> done = {}) {
    while (const std::optional<Task> task = plan.next(done)) {
        const double seconds =
            task->method == path_tracer_name ? path_tracer_seconds(task->budget) : first * std::pow(growth, task->budget);
        done.push_back(point(task->method, task->budget, task->seed, seconds));
    }
    return done;
}

TEST(RunPlan, ClimbsUntilARunTakesThatLong) {
    const RunPlan plan({path_tracer_name, "sets"}, 2, 10);
    const std::vector<RunPoint> done = simulate(plan, 0.2, 1.7);
    EXPECT_NE(find_point(done, path_tracer_name, 5, 1), nullptr) << "10 s";
    EXPECT_EQ(find_point(done, path_tracer_name, 6, 0), nullptr) << "30 s";
    EXPECT_NE(find_point(done, "sets", 8, 1), nullptr) << "0.2 * 1.7^8 = 14 s covers 10 s";
    EXPECT_EQ(find_point(done, "sets", 9, 0), nullptr) << "10 s are reached";
    EXPECT_EQ(done.size(), 2U * (6 + 9));
    EXPECT_EQ(plan.expected_seconds(done), 0);
}

TEST(RunPlan, StopsBeforeARunOfThreeTimesAsLong) {
    const std::vector<RunPoint> done = simulate(RunPlan({"sets"}, 1, 10), 0.15, 3.9);
    EXPECT_NE(find_point(done, "sets", 3, 0), nullptr) << "8.9 s";
    EXPECT_EQ(find_point(done, "sets", 4, 0), nullptr) << "35 s";
}

TEST(RunPlan, WholeCurvesOfOneSeedFirst) {
    const std::vector<RunPoint> done = simulate(RunPlan({path_tracer_name, "sets"}, 2, 10), 0.2, 1.7);
    for (std::size_t i = 0; i < done.size(); ++i) {
        EXPECT_EQ(done[i].seed, i < done.size() / 2 ? 0U : 1U);
    }
    EXPECT_EQ(done[0].method, path_tracer_name);
    EXPECT_EQ(done[1].method, "sets") << "methods alternate, so that a drift of the machine's speed meets all";
}

TEST(RunPlan, GoesOnWhereItStopped) {
    const RunPlan plan({path_tracer_name, "sets", "fixed"}, 3, 5);
    const std::vector<RunPoint> whole = simulate(plan, 0.3, 2);
    for (std::size_t kept = 0; kept <= whole.size(); ++kept) {
        const std::vector<RunPoint> resumed = simulate(plan, 0.3, 2, {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(kept)});
        ASSERT_EQ(resumed.size(), whole.size()) << kept;
        for (std::size_t i = 0; i < whole.size(); ++i) {
            ASSERT_EQ(resumed[i].method + std::to_string(resumed[i].budget), whole[i].method + std::to_string(whole[i].budget)) << kept;
        }
    }
}

TEST(RunPlan, ALadderThatEndsStaysEnded) {
    RunPlan plan({path_tracer_name, "sets"}, 2, 10);
    plan.end_ladder("sets", 3);
    const std::vector<RunPoint> done = simulate(plan, 0.2, 1.7);
    EXPECT_NE(find_point(done, "sets", 2, 1), nullptr);
    EXPECT_EQ(find_point(done, "sets", 3, 0), nullptr);
}

TEST(RunPlan, ExpectsLessAndLess) {
    const RunPlan plan({path_tracer_name, "sets"}, 3, 10);
    std::vector<RunPoint> whole = simulate(plan, 0.2, 1.7), done;
    for (const RunPoint& run : whole) {
        done.push_back(run);
        if (done.size() > whole.size() / 3) {  // seed 0 is done: no guess any more
            const double left = plan.expected_seconds(done);
            double truth = 0;
            for (std::size_t i = done.size(); i < whole.size(); ++i) {
                truth += whole[i].seconds;
            }
            ASSERT_NEAR(left, truth, 1e-9);
        }
    }
}

TEST(Methods, EveryStepIsLargerAndSaysItsOptions) {
    for (const MeasuredMethod& method : all_methods()) {
        for (int step = 1; step < 12; ++step) {
            const RenderOptions now = method.budget(step).options, before = method.budget(step - 1).options;
            const std::string& flags = method.budget(step).flags;
            if (now.method == MethodName::surface) {  // a ladder of time
                EXPECT_GT(now.seconds, before.seconds);
                EXPECT_NE(flags.find("--method surface --time "), std::string::npos) << flags;
                EXPECT_EQ(std::stod(flags.substr(flags.rfind(' '))), now.seconds) << flags;
            } else {
                EXPECT_GT(now.pencils, before.pencils) << method.name;
                EXPECT_NE(flags.find("--pencils " + std::to_string(now.pencils)), std::string::npos) << flags;
            }
        }
        EXPECT_EQ(&find_method(method.name), &method);
    }
    EXPECT_NEAR(path_tracer_seconds(0), 0.03, 1e-12);
    EXPECT_NEAR(path_tracer_seconds(5), 10, 1e-12);
    EXPECT_EQ(run_flags(path_tracer_name, 0), "--time 0.03");
}

/// Two curves that cross at 1 s: the baseline falls as t^-0.5 from 0.1 at 1 s, the other stays at 0.1 until 4 s.
std::vector<NamedCurve> crossing() { return {{"path-tracer", {{0.01, 1}, {1, 0.1}, {100, 0.01}}}, {"sets", {{0.25, 0.1}, {4, 0.1}}}}; }

TEST(Verdict, AtEqualTime) {
    const std::vector<NamedCurve> curves = crossing();
    const Verdict before = judge(curves, 0.5), after = judge(curves, 4), early = judge(curves, 0.1), late = judge(curves, 1000);
    EXPECT_EQ(before.ahead, 1);
    EXPECT_NEAR(before.lead, std::sqrt(2), 1e-12);
    EXPECT_EQ(after.ahead, 0);
    EXPECT_NEAR(after.lead, 2, 1e-12);
    EXPECT_EQ(early.ahead, 0);
    EXPECT_EQ(early.second, -1) << "the other has no image yet";
    EXPECT_EQ(late.ahead, -1);
}

TEST(Verdict, AtEqualError) {
    std::vector<NamedCurve> curves = crossing();
    curves.push_back({"fast", {{0.001, 1}, {0.1, 0.1}}});
    const TimesToError row = times_to(curves, 0.1);
    EXPECT_NEAR(row.times[0].value, 1, 1e-12);
    EXPECT_NEAR(row.speedups[1], 4, 1e-12);
    EXPECT_NEAR(row.speedups[2], 10, 1e-9);
    EXPECT_EQ(times_to(curves, 0.05).speedups[1], 0) << "not reached, and not guessed";
}

TEST(Verdict, RoundErrorsLieInTheRange) {
    EXPECT_EQ(round_errors(crossing()).size(), 7U);  // 1, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01
    EXPECT_TRUE(round_errors({}).empty());
    EXPECT_TRUE(round_errors({{"a", {{1, 0.3}, {2, 0.25}}}}).empty());
}

TEST(Summary, BiasAndNoiseAddUp) {
    // One run: 3^2 + 4^2; the mean of four: 3^2 + 4^2 / 4.
    const BiasAndNoise parts = split_error(25, 13, 4);
    EXPECT_NEAR(parts.bias, 3, 1e-12);
    EXPECT_NEAR(parts.noise, 4, 1e-12);
    EXPECT_EQ(split_error(25, 26, 4).noise, 0) << "by chance";
}

TEST(Summary, SeedsAreAveraged) {
    ConvergeOptions options;
    options.methods = {"sets"};
    options.seeds = 3;
    options.folder = "/nonexistent";
    const std::vector<RunPoint> points{point("sets", 0, 0, 1, 0.01), point("sets", 0, 1, 5, 0.04), point("sets", 0, 2, 2, 0.04),
                                       point("sets", 0, 3, 9, 9), point("thesis", 0, 0, 1)};
    const std::vector<MethodSummary> methods = summarise(points, options, {});
    ASSERT_EQ(methods.size(), 1U) << "a method that was not asked for";
    ASSERT_EQ(methods[0].budgets.size(), 1U);
    const BudgetSummary& budget = methods[0].budgets[0];
    EXPECT_EQ(budget.seeds.size(), 3U) << "a seed that was not asked for";
    EXPECT_EQ(budget.seconds, 2) << "median";
    EXPECT_NEAR(budget.relative_error, std::sqrt(0.03), 1e-12);
    EXPECT_NEAR(budget.rmse, std::sqrt(0.03), 1e-12);
    EXPECT_EQ(budget.stages[0].second, 0.5) << "median";
    EXPECT_FALSE(budget.bias) << "no images";
}

TEST(Truth, NoiseOfTwoHalves) {
    std::mt19937 random(3);
    std::normal_distribution<float> normal(0, 0.02F);
    std::vector<float> a(30000), b(a.size()), mean(a.size()), exact(a.size(), 1.0F);
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = 1 + normal(random);
        b[i] = 1 + normal(random);
        mean[i] = (a[i] + b[i]) / 2;
    }
    const double true_noise = measure({mean.data(), exact.data(), mean.size() / 3, 3}).rel_mse;
    EXPECT_NEAR(noise_of_halves(a, b), true_noise, 0.05 * true_noise);
}

}  // namespace
}  // namespace pencil
