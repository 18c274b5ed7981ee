// Groups of pencils by proximity.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "line/group_leaders.h"
#include "pencils/low_discrepancy.h"

namespace pencil {
namespace {

std::vector<glm::vec4> centres(int count) {
    std::vector<glm::vec4> out;
    for (int i = 0; i < count; ++i)
        out.emplace_back(random_unit(7, 0, i), random_unit(7, 1, i), i % 3 == 0 ? random_unit(7, 2, i) : 0.01 * random_unit(7, 2, i), 0);
    return out;
}

TEST(GroupLeaders, AreSomeOfTheCentresAndEachOnce) {
    for (const int count : {1, 4, 5, 63, 1000}) {
        const std::vector<glm::vec4> all = centres(count), leaders = group_leaders(all, 4);
        EXPECT_GE(static_cast<int>(leaders.size()) * 4, count);
        EXPECT_LE(static_cast<int>(leaders.size()), std::max(count / 2, 1)) << "halves of five are two and three";
        for (const glm::vec4& leader : leaders) {
            EXPECT_EQ(std::count(leaders.begin(), leaders.end(), leader), 1);
            EXPECT_NE(std::find(all.begin(), all.end(), leader), all.end());
        }
    }
    EXPECT_TRUE(group_leaders({}, 4).empty());
}

TEST(GroupLeaders, AreAsDenseAsTheCentres) {
    const std::vector<glm::vec4> all = centres(4096), leaders = group_leaders(all, 4);
    const auto low = [](const std::vector<glm::vec4>& of) {
        return static_cast<double>(std::count_if(of.begin(), of.end(), [](const glm::vec4& c) { return c.z < 0.01F; })) /
               static_cast<double>(of.size());
    };
    EXPECT_NEAR(low(leaders), low(all), 0.03);
    double furthest = 0;  // of a centre from its nearest leader
    for (const glm::vec4& c : all) {
        float nearest = 2.0F;
        for (const glm::vec4& leader : leaders) nearest = std::min(nearest, glm::distance(c, leader));
        furthest = std::max(furthest, static_cast<double>(nearest));
    }
    EXPECT_LT(furthest, 0.2) << "1365 groups in a cube, and as many in a slab";
}

}  // namespace
}  // namespace pencil
