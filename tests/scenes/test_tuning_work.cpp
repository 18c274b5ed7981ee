// The work that devices are tuned by, on the device of the tests: it repeats, other profiles give the same results, and their times are there.
#include "scenes/scene_builder.h"
#include "tune/tune_maps.h"
#include "tune/tuning_work.h"

namespace pencil::test {
namespace {

TEST(TuningWork, OtherProfilesGiveTheSameImage) {
    const std::shared_ptr<Device> own = Device::open("");
    TuningWork work(own, {});
    DeviceProfile groups = own->profile(), blocks = groups, images = groups;
    groups.group = 16;
    groups.groups["project_pencils"] = 2;
    blocks.block = 2;
    images.atlas_image = true;
    const std::vector<Trial> trials =
        try_profiles([&](const DeviceProfile& profile) { return work.run(profile); }, {own->profile(), groups, blocks, images}, 1);
    for (const Trial& trial : trials) {
        EXPECT_EQ(trial.refused, "");
        ASSERT_EQ(trial.rounds.size(), 1U);
        for (const char* kernel : {"project_pencils", "trace_hemispheres", "light_surfels", "project_surface_pencils"})
            EXPECT_GT(trial.rounds[0].count(kernel), 0U) << kernel;
        EXPECT_GT(sum_of(trial.rounds[0], {}), 0);
    }
}

TEST(TuningWork, StopsWhereItIsAskedTo) {
    TuningWork work(Device::open(""), [](const std::string&, double) { return false; });
    EXPECT_THROW(work.run(generic_profile(device()->info())), TuneStopped);
}

TEST(TuningWork, EveryWayToMakeMapsIsTimed) {
    for (const MapTimes& times : measure_maps(Device::open(""), 1, [] {}))
        for (const double seconds : times.seconds) {
            EXPECT_GT(seconds, 0) << times.triangles << " triangles";
            EXPECT_LT(seconds, 60) << "infinite: other maps than the rasteriser's";
        }
}

}  // namespace
}  // namespace pencil::test
