// A render that goes on from a checkpoint is the render that never stopped, bit for bit; one whose device fails keeps what it has.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "render/checkpoint.h"
#include "render/render_session.h"
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"
#include "util/archive.h"
#include "util/error.h"

namespace pencil::test {
namespace {

constexpr int steps = 7;  // two generations and more of world sets

RenderOptions small_options() {
    RenderOptions options;
    options.pencils = 24;
    options.light_samples = 8;
    options.width = 24;
    options.height = 16;
    options.target_error = 1e-9;
    return options;
}

bool same(const std::vector<Layer>& a, const std::vector<Layer>& b) {
    return std::equal(
        a.begin(), a.end(), b.begin(), b.end(), [](const Layer& x, const Layer& y) { return x.name == y.name && x.pixels == y.pixels; });
}

struct Straight {
    std::vector<std::vector<char>> states;  // after each step
    std::vector<Layer> layers;
    double error = 0;
};

Straight run_straight(const Scene& scene, const RenderOptions& options = small_options()) {
    Straight straight;
    RenderSession session(scene, options, device());
    for (int step = 0; step < steps; ++step) {
        session.advance();
        straight.states.push_back(session.save());
    }
    straight.layers = session.snapshot();
    straight.error = session.estimated_error();
    return straight;
}

void expect_the_same_from_every_step(const Scene& scene, const RenderOptions& options = small_options()) {
    const Straight straight = run_straight(scene, options);
    for (int begin = 1; begin <= steps; ++begin) {
        RenderSession session(scene, options, device());
        session.resume(straight.states[static_cast<std::size_t>(begin - 1)]);
        EXPECT_TRUE(session.has_step());
        for (int step = begin; step < steps; ++step) session.advance();
        EXPECT_TRUE(same(session.snapshot(), straight.layers)) << "from step " << begin;
        EXPECT_EQ(session.estimated_error(), straight.error) << "from step " << begin;
        EXPECT_EQ(session.stats().passes, steps);
    }
}

TEST(Checkpoint, GoesOnAsIfItHadNeverStopped) { expect_the_same_from_every_step(cie_cube(0.5)); }

TEST(Checkpoint, GoesOnWithSpotsAndSplitPixels) { expect_the_same_from_every_step(room_with_near_lamp(0.005)); }

TEST(Checkpoint, GoesOnWithEveryKindOfLightAndMaterial) { expect_the_same_from_every_step(room_of_everything()); }

TEST(Checkpoint, GoesOnWithSeedsThatWereAdded) {
    Scene scene = two_furnaces();
    scene.point_lights.push_back({{0.9, 0.4, 0.3}, glm::vec3(0.5F)});  // else it is no matter where pencils lie
    expect_the_same_from_every_step(scene);
    RenderSession session(scene, small_options(), device());
    session.advance();
    const std::vector<std::string> lines = session.stats().explain;
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(),
                            [](const std::string& line) { return line.find("first seeds missed") != std::string::npos; }));
}

/// A box narrower than a pixel, which the film finds in a later pass by chance: the set that stood then does not begin there when it is placed once more.
TEST(Checkpoint, GoesOnWithoutSeedsThatWereFoundLater) {
    Scene scene;
    add_box(scene, {-1, -0.75, -1}, {1, 0.75, 1}, {glm::vec3(0.5F), glm::vec3(0.01F)});
    add_box(scene, {0.3, -0.1, -0.9}, {0.315, 0.1, 0.9}, {glm::vec3(0.9F), glm::vec3(0.1F)});
    scene.point_lights.push_back({{0.3075, 0, 0.3}, glm::vec3(1e-4F)});
    look_at(scene, {0, 0, 2}, {0, 0, 0}, {0, 1, 0}, 65.8, 48, 36);
    scene.sensor.near_clip = 1.5;
    RenderOptions options = small_options();
    options.width = 48;
    options.height = 36;
    expect_the_same_from_every_step(scene, options);
}

/// Stopped after each step: nothing drifts.
TEST(Checkpoint, GoesOnAgainAndAgain) {
    const Scene scene = room_of_everything();
    const Straight straight = run_straight(scene);
    std::vector<char> state = straight.states.front();
    for (int step = 1; step < steps; ++step) {
        RenderSession session(scene, small_options(), device());
        session.resume(state);
        session.advance();
        state = session.save();
    }
    RenderSession last(scene, small_options(), device());
    last.resume(state);
    EXPECT_TRUE(same(last.snapshot(), straight.layers));
}

TEST(Checkpoint, ARenderThatHasEndedGoesOnOnlyWhereItIsAskedTo) {
    const Scene scene = cie_cube(0.5);
    RenderOptions options = small_options();
    options.target_error = 0.05;
    RenderSession session(scene, options, device());
    while (session.advance()) {
    }
    const std::vector<char> state = session.save();
    const int passes = session.stats().passes;
    RenderSession again(scene, options, device());
    again.resume(state);
    EXPECT_FALSE(again.advance());
    EXPECT_TRUE(same(again.snapshot(), session.snapshot()));
    options.target_error = 1e-9;
    RenderSession further(scene, options, device());
    further.resume(state);
    further.advance();
    EXPECT_EQ(further.stats().passes, passes + 1);
}

/// Whatever the bytes: an ArchiveError, or a session that goes on.
TEST(Checkpoint, DamagedStatesAreErrorsNotCrashes) {
    const Scene scene = cie_cube(0.5);
    const std::vector<char> state = run_straight(scene).states.front();
    for (const std::size_t size : {std::size_t{0}, std::size_t{10}, state.size() / 2, state.size() - 1}) {
        RenderSession session(scene, small_options(), device());
        EXPECT_THROW(session.resume({state.begin(), state.begin() + static_cast<std::ptrdiff_t>(size)}), ArchiveError) << size;
    }
    std::vector<char> longer = state;
    longer.push_back(0);
    RenderSession session(scene, small_options(), device());
    EXPECT_THROW(session.resume(longer), ArchiveError);
    RenderOptions larger = small_options();
    larger.width = 25;
    RenderSession other(scene, larger, device());
    EXPECT_THROW(other.resume(state), ArchiveError) << "an image of another size";
}

TEST(Checkpoint, TheLineMethodSaysThatItCannot) {
    RenderOptions options = small_options();
    options.method = MethodName::line;
    RenderSession session(cie_cube(0.5), options, device());
    EXPECT_THROW(session.save(), UsageError);
}

class CheckpointFile : public testing::Test {
protected:
    void SetUp() override {
        std::filesystem::create_directories(folder);
        write_checkpoint(file, identity, state);
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    std::string refusal(const RenderIdentity& of) const {
        try {
            read_checkpoint(file, of);
        } catch (const UsageError& error) {
            return error.what();
        }
        return "";
    }
    std::vector<char> bytes() const {
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    void replace(const std::vector<char>& by) const {
        std::ofstream(file, std::ios::binary).write(by.data(), static_cast<std::streamsize>(by.size()));
    }

    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "pencil-checkpoint-test";
    const std::filesystem::path file = folder / "state";
    const RenderIdentity identity{{"scene", "1"}, {"--seed", "2"}};
    const std::vector<char> state{1, 2, 3};
};

TEST_F(CheckpointFile, HoldsTheState) { EXPECT_EQ(read_checkpoint(file, identity), state); }

TEST_F(CheckpointFile, SaysHowAnotherRenderDiffers) {
    EXPECT_NE(refusal({{"scene", "1"}, {"--seed", "3"}}).find("its --seed is 2, here --seed is 3"), std::string::npos);
    EXPECT_NE(refusal({{"scene", "1"}}).find("another version"), std::string::npos);
}

TEST_F(CheckpointFile, AnyDamageIsRefused) {
    const std::vector<char> whole = bytes();
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::vector<char> one = whole;
        one[i] = static_cast<char>(one[i] ^ 1);
        replace(one);
        EXPECT_NE(refusal(identity), "") << "byte " << i;
        replace({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(i)});
        EXPECT_NE(refusal(identity), "") << "the first " << i << " bytes";
    }
    std::filesystem::remove(file);
    EXPECT_NE(refusal(identity).find("no such file"), std::string::npos);
    std::filesystem::create_directory(file);
    EXPECT_NE(refusal(identity).find("no regular file"), std::string::npos);
}

}  // namespace
}  // namespace pencil::test
