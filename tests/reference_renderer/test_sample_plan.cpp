// How many samples the reference takes, by a clock that the test turns: a sample costs what the test says.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/sample_plan.h"

namespace {

using namespace pencil;

struct Spent {
    int samples = 0, passes = 0;
    double seconds = 0;
};

/// Follows the plan; `cost(sample)`: seconds that a sample takes.
template <typename Cost>
Spent follow(const ReferenceOptions& options, const Cost& cost) {
    SamplePlan plan(options);
    Spent spent;
    for (SamplePlan::Pass pass = plan.next(0); pass.samples > 0; pass = plan.next(spent.seconds)) {
        for (int s = 0; s < pass.samples; ++s) spent.seconds += cost(spent.samples++);
        if (++spent.passes > 1000000) break;
    }
    return spent;
}

TEST(SamplePlan, TimeBudgetIsKeptToHalfASample) {
    for (const double budget : {0.01, 0.4, 60.0})
        for (const double cost : {1e-5, 1e-3, 0.017}) {
            ReferenceOptions options;
            options.seconds = budget;
            const Spent spent = follow(options, [&](int) { return cost; });
            if (cost >= 2 * budget) {
                EXPECT_EQ(spent.samples, 1);
                continue;
            }
            EXPECT_LE(std::abs(spent.seconds - budget), 0.5001 * cost) << "budget " << budget << ", a sample takes " << cost;
        }
}

TEST(SamplePlan, NeverLessThanOneSample) {
    ReferenceOptions options;
    options.seconds = 1e-6;
    EXPECT_EQ(follow(options, [](int) { return 1.0; }).samples, 1);
}

/// Samples that become ten times slower end the work at most one pass late.
TEST(SamplePlan, AMachineThatSlowsDownIsNoticed) {
    ReferenceOptions options;
    options.seconds = 1.0;
    const Spent spent = follow(options, [](int sample) { return sample < 300 ? 1e-3 : 1e-2; });
    EXPECT_GT(spent.samples, 300);
    EXPECT_LT(spent.seconds, 1.5);
}

TEST(SamplePlan, SamplesPerPixelDoNotDependOnTheClock) {
    ReferenceOptions options;
    for (const int spp : {1, 7, 256}) {
        options.spp = spp;
        EXPECT_EQ(follow(options, [](int) { return 100.0; }).samples, spp);
    }
}

}  // namespace
