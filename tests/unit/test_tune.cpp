// The search for a device's profile, with work whose times are made up: what wins is kept, what does not is not, and again the same.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tune/tune.h"
#include "tune/tune_maps.h"
#include "util/error.h"

namespace {

using namespace pencil;

DeviceInfo cpu() {
    DeviceInfo info;
    info.is_cpu = true;
    info.native_float_width = 16;
    info.max_work_group = 4096;
    return info;
}

/// Times by kernel that a profile takes [s], without noise.
using Model = std::function<KernelTimes(const DeviceProfile&)>;

/// Work that takes them with a noise that only adds: up to `mostly`, now and then up to half.
Workload work_of(const Model& model, unsigned seed, double mostly = 0.04) {
    const auto random = std::make_shared<std::mt19937>(seed);
    return [model, random, mostly](const DeviceProfile& profile) {
        std::uniform_real_distribution<double> uniform(0, 1);
        Sample sample{model(profile), {1.0F, 2.0F, 3.0F}};
        for (auto& [kernel, seconds] : sample.seconds)
            seconds *= 1 + (uniform(*random) < 0.1 ? std::max(0.5, mostly) : mostly) * uniform(*random);
        return sample;
    };
}

Tuned tune(const Model& model, unsigned seed = 1, const std::optional<DeviceProfile>& stored = {}) {
    return tune_launches(work_of(model, seed), cpu(), {7, true, stored, {}});
}

KernelTimes even(const DeviceProfile&) { return {{"project_pencils", 0.1}, {"trace_hemispheres", 0.1}, {"light_surfels", 0.05}}; }

/// Packets of 8 take 0.8 of the time, light_surfels with groups of 32 half of its own.
KernelTimes has_winners(const DeviceProfile& profile) {
    KernelTimes times = even(profile);
    for (auto& [kernel, seconds] : times) seconds *= profile.packet_width == 8 ? 0.8 : profile.packet_width == 16 ? 1 : 2;
    if (profile.group_of("light_surfels") == 32) times["light_surfels"] *= 0.5;
    return times;
}

bool same(const DeviceProfile& a, const DeviceProfile& b) {
    return a.packet_width == b.packet_width && a.block == b.block && a.group == b.group && a.groups == b.groups;
}

std::size_t kept(const Tuned& tuned) {
    return static_cast<std::size_t>(std::count_if(
        tuned.rows.begin(), tuned.rows.end(), [](const TuneRow& row) { return row.outcome == "kept"; }));
}

TEST(Tune, GenericProfileStaysWhereNothingWins) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Tuned tuned = tune(even, seed);
        EXPECT_TRUE(same(tuned.profile, generic_profile(cpu()))) << seed;
        EXPECT_EQ(kept(tuned), 0U) << seed;
    }
}

TEST(Tune, NothingWinsByNoise) {
    // A machine that others use as much: times vary by a factor of two.
    std::size_t changed = 0;
    for (unsigned seed = 0; seed < 100; ++seed)
        changed += same(tune_launches(work_of(even, seed, 1.0), cpu(), {7, true, {}, {}}).profile, generic_profile(cpu())) ? 0 : 1;
    EXPECT_LE(changed, 2U);
}

TEST(Tune, WhatWinsIsKeptAndAgainTheSame) {
    DeviceProfile expected = generic_profile(cpu());
    expected.packet_width = 8;
    expected.groups["light_surfels"] = 32;
    std::optional<DeviceProfile> stored;
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Tuned tuned = tune(has_winners, seed, stored);
        EXPECT_TRUE(same(tuned.profile, expected)) << seed;
        EXPECT_TRUE(tuned.profile.tuned);
        if (seed >= 10) stored = tuned.profile;
    }
}

TEST(Tune, OfEqualGroupsTheNearestIsTaken) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Tuned tuned = tune(
            [](const DeviceProfile& profile) {
                KernelTimes times = even(profile);
                if (profile.group_of("project_pencils") > 8) times["project_pencils"] *= 0.7;
                return times;
            },
            seed);
        EXPECT_EQ(tuned.profile.groups, (std::map<std::string, std::size_t>{{"project_pencils", 16}})) << seed;
    }
}

TEST(Tune, ImagesAreTakenWhereTheyAreFaster) {
    for (const double factor : {0.5, 3.0})
        for (unsigned seed = 0; seed < 5; ++seed) {
            const Tuned tuned = tune(
                [factor](const DeviceProfile& profile) {
                    KernelTimes times = even(profile);
                    if (!profile.atlas_image) return times;
                    times["project_pencils"] *= factor;
                    times["copy to image"] = 0.01;
                    return times;
                },
                seed);
            EXPECT_EQ(tuned.profile.atlas_image, factor < 1) << seed;
        }
}

TEST(Tune, WrongResultsAndFailuresAreRefused) {
    const Workload work = [](const DeviceProfile& profile) {
        Sample sample{has_winners(profile), {1.0F, 2.0F, 3.0F}};
        if (profile.packet_width == 8) sample.image[1] = 2.05F;
        if (profile.packet_width == 4) sample.image[1] = NAN;
        if (profile.group_of("light_surfels") == 32) throw DeviceError("out of resources");
        return sample;
    };
    const Tuned tuned = tune_launches(work, cpu(), {3, false, {}, {}});
    EXPECT_TRUE(same(tuned.profile, generic_profile(cpu())));
    std::size_t wrong = 0, failed = 0;
    for (const TuneRow& row : tuned.rows) {
        wrong += row.outcome.rfind("wrong results", 0) == 0 ? 1 : 0;
        failed += row.outcome == "the device fails" ? 1 : 0;
        EXPECT_NE(row.outcome, "kept");
    }
    EXPECT_EQ(wrong, 2U);
    EXPECT_GE(failed, 1U);
}

TEST(Tune, AStoredProfileStaysWhileItWins) {
    DeviceProfile stored = generic_profile(cpu());
    stored.groups["light_surfels"] = 32;
    const auto faster = [](double factor) {
        return [factor](const DeviceProfile& profile) {
            KernelTimes times = even(profile);
            if (profile.group_of("light_surfels") == 32) times["light_surfels"] *= factor;
            return times;
        };
    };
    EXPECT_TRUE(same(tune(faster(0.94), 2, stored).profile, stored)) << "it wins, by too little for a new one";
    EXPECT_TRUE(same(tune(faster(0.94), 2).profile, generic_profile(cpu())));
    EXPECT_TRUE(same(tune(faster(1.0), 2, stored).profile, generic_profile(cpu()))) << "it does not win any more";
}

TEST(Tune, OneLuckyRoundWinsNothing) {
    Trial generic, lucky;
    for (const double seconds : {1.0, 1.02, 1.1, 1.01, 1.05}) generic.rounds.push_back({{"a", seconds}});
    for (const double seconds : {1.0, 1.03, 0.7, 1.02, 1.04}) lucky.rounds.push_back({{"a", seconds}});
    EXPECT_GT(time_ratio(lucky, generic), 0.99);
    EXPECT_EQ(time_ratio(lucky, generic, {"b"}), 1) << "a kernel that was not launched";
}

/// Times of a device whose paths take `factors` of what the model says.
std::vector<MapTimes> map_times(const MapCosts& factors) {
    std::vector<MapTimes> times;
    for (const int triangles : {40, 5000})
        for (const int size : {16, 64}) {
            MapTimes t{triangles, {64, size}, {}};
            for (std::size_t path = 0; path < factors.size(); ++path)
                t.seconds[path] = factors[path] * maps_seconds(visibility_paths[path], triangles, t.batch, 2);
            times.push_back(t);
        }
    return times;
}

TEST(Tune, CostsOfMapsAreKeptWhereTheyChooseBetter) {
    const MapCosts none{1, 1, 1};
    std::vector<TuneRow> rows;
    EXPECT_EQ(choose_costs(map_times({1.1, 0.9, 1.05}), 2, none, rows), none);
    EXPECT_EQ(choose_costs(map_times({0.1, 0.1, 0.1}), 2, none, rows), none) << "the choices are the same";
    const MapCosts slow_rays = choose_costs(map_times({1, 1, 30}), 2, none, rows);
    EXPECT_GT(slow_rays[2], 20);
    EXPECT_NEAR(slow_rays[0], 1, 1e-9);
    EXPECT_EQ(choose_costs(map_times({1.03, 1, 29}), 2, slow_rays, rows), slow_rays) << "again the same";
    EXPECT_EQ(rows.back().outcome, "kept");
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(choose_costs(map_times({1, 1, infinite}), 2, none, rows)[2], costs_of_wrong_path);
}

}  // namespace
