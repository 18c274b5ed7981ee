// When the passes of a render are enough.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "surface/patience.h"

namespace {

using namespace pencil;

constexpr double target = 1e-3;
const CertifiedError unchecked;

/// Passes until enough, and what is said then; `so_far`: what so many passes say.
struct End {
    int passes;
    std::string reason;
};
End end_of(const std::function<PassesSoFar(int)>& so_far) {
    Patience patience(target);
    for (int passes = 1; passes <= 1000; ++passes)
        if (const Patience::Answer answer = patience.ask(so_far(passes)); answer.enough) return {passes, answer.reason.value_or("")};
    return {-1, ""};
}

TEST(Patience, ThreePassesAreTheLeast) {
    const End end = end_of([](int passes) { return PassesSoFar{passes, double(passes), 0, 0, 0, unchecked}; });
    EXPECT_EQ(end.passes, 3);
    EXPECT_EQ(end.reason, "");
}

TEST(Patience, TheTargetEndsIt) {
    const End end = end_of([](int passes) { return PassesSoFar{passes, double(passes), 0.02 / passes, 0.02 / passes, 0, unchecked}; });
    EXPECT_EQ(end.passes, 20);
    EXPECT_EQ(end.reason, "");
}

TEST(Patience, TheMeanIsToBeKnownTooButNotForEver) {
    EXPECT_EQ(end_of([](int passes) { return PassesSoFar{passes, double(passes), 0, 0, 0.03 / passes, unchecked}; }).passes, 9);
    EXPECT_EQ(end_of([](int passes) { return PassesSoFar{passes, double(passes), 0, 0, 1, unchecked}; }).passes, 128);
}

TEST(Patience, PassesThatAgreeOnceByChanceGoOn) {
    const auto chance = [](double once) {
        return end_of([=](int passes) { return PassesSoFar{passes, double(passes), 0, 0, passes == 5 ? once : 0.01, unchecked}; }).passes;
    };
    EXPECT_EQ(chance(0.0035), 128);
    EXPECT_EQ(chance(0.002), 5) << "they agree too well for that";
}

/// Of a render that goes on to a smaller error: what was well enough for the last one is not for this.
TEST(Patience, AnotherTargetAsksAnew) {
    const auto ask = [](Patience& patience, double mean_error) { return patience.ask({4, 4, 0, 0, mean_error, unchecked}).enough; };
    for (const auto& [before, enough] : {std::pair{0.01, false}, {0.0038, true}}) {
        Patience loose(0.1);
        ask(loose, before);
        Archive kept;
        loose.transfer(kept);
        Patience strict(target);
        Archive again(kept.take());
        strict.transfer(again);
        EXPECT_EQ(ask(strict, 0.0035), enough);
    }
}

TEST(Patience, LightPathsThatContradictAreHeard) {
    CertifiedError certified;
    certified.points = 100;
    certified.mean_bias = -0.02;
    certified.mean_error = 0.005;
    const auto contradicted = [&](int passes) { return PassesSoFar{passes, double(passes), 0, 0, 0, certified}; };
    EXPECT_EQ(end_of(contradicted).passes, 128);
    certified.mean_error = 0.015;  // they do not know enough
    EXPECT_EQ(end_of(contradicted).passes, 3);
    certified.points = 1;
    certified.mean_error = 0;
    EXPECT_EQ(end_of(contradicted).passes, 3);
}

TEST(Patience, AnErrorThatFallsNoFurtherEndsIt) {
    const End end = end_of([](int passes) { return PassesSoFar{passes, double(passes), 2 * target, 2 * target, 0, unchecked}; });
    EXPECT_EQ(end.passes, 64);
    EXPECT_NE(end.reason.find("falls no further"), std::string::npos) << end.reason;
    EXPECT_EQ(end_of([](int passes) { return PassesSoFar{passes, double(passes), 1000 * target, 1000 * target, 0, unchecked}; }).passes,
              16);
    EXPECT_EQ(end_of([](int passes) { return PassesSoFar{passes, double(passes), 2 * target, 2 * target, 1, unchecked}; }).passes, 128)
        << "as long as the mean is not known";
    // The noise of light paths does not say that there is no hope.
    EXPECT_EQ(end_of([](int passes) { return PassesSoFar{passes, double(passes), 1000 * target, target, 0, unchecked}; }).passes, 64);
    // One that falls by a fifth from doubling to doubling is worth waiting for.
    const End slow = end_of([](int passes) {
        return PassesSoFar{passes, double(passes), 50 * target * std::pow(passes, -0.33), 50 * target * std::pow(passes, -0.33),
                           0,      unchecked};
    });
    EXPECT_EQ(slow.passes, 256);
    EXPECT_NE(slow.reason.find("above --target-error"), std::string::npos) << slow.reason;
}

/// Passes that cost four times as much: a quarter of them.
TEST(Patience, WorkCountsNotPasses) {
    EXPECT_EQ(end_of([](int passes) { return PassesSoFar{passes, 4.0 * passes, 0, 0, 1, unchecked}; }).passes, 32);
    EXPECT_EQ(end_of([](int passes) { return PassesSoFar{passes, 4.0 * passes, 2 * target, 2 * target, 0, unchecked}; }).passes, 16);
}

TEST(Patience, ErrorsThatAreNotFiniteAreNamed) {
    for (const double error : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        const End end = end_of([&](int passes) { return PassesSoFar{passes, double(passes), error, error, 0, unchecked}; });
        EXPECT_EQ(end.passes, 2);
        EXPECT_NE(end.reason.find("not finite"), std::string::npos) << end.reason;
    }
}

}  // namespace
