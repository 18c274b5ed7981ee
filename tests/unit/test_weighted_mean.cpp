// How well a weighted mean is known, from its values and from groups of them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "film/weighted_mean.h"
#include "reference/random.h"

namespace {

using namespace pencil;

/// Mean over trials of the two estimated square errors, over the true one: values 2 with noise of their own, and of their groups.
struct Known {
    double by_values = 0, by_groups = 0;
};
Known known(int groups, int each, double own, double shared) {
    ref::Random random(11);
    const auto noise = [&](double sigma) { return sigma * std::sqrt(12.0) * (random.uniform() - 0.5); };
    constexpr int trials = 4000;
    Known sums;
    double truth = 0;
    for (int trial = 0; trial < trials; ++trial) {
        WeightedMean mean;
        for (int g = 0; g < groups; ++g) {
            const double group = noise(shared);
            for (int k = 0; k < each; ++k) mean.add(2 + group + noise(own), 1 + g % 2, g);
        }
        sums.by_values += mean.square_error();
        sums.by_groups += mean.square_error_of_groups();
        truth += (mean.mean() - 2) * (mean.mean() - 2);
    }
    return {sums.by_values / truth, sums.by_groups / truth};
}

TEST(WeightedMean, ValuesTellTheErrorOfIndependentOnes) {
    for (const int groups : {4, 20}) {
        EXPECT_NEAR(known(groups, 1, 0.1, 0).by_values, 1.0, 0.15) << groups;
        EXPECT_NEAR(known(groups, 4, 0.1, 0).by_values, 1.0, 0.15) << groups;
        EXPECT_NEAR(known(groups, 4, 0.1, 0).by_groups, 1.0, 0.15) << groups;
    }
}

TEST(WeightedMean, GroupsTellWhatTheirValuesShare) {
    EXPECT_LT(known(8, 8, 0.1, 0.1).by_values, 0.4) << "values alone do not see it";
    EXPECT_NEAR(known(8, 8, 0.1, 0.1).by_groups, 1.0, 0.15);
}

TEST(WeightedMean, FewTellNothing) {
    WeightedMean mean;
    EXPECT_EQ(mean.mean(), 0);
    mean.add(3, 2, 0);
    EXPECT_EQ(mean.mean(), 3);
    EXPECT_EQ(mean.square_error(), std::numeric_limits<double>::infinity());
    mean.add(5, 2, 1);
    EXPECT_EQ(mean.mean(), 4);
    EXPECT_EQ(mean.square_error_of_groups(), 0);
}

}  // namespace
