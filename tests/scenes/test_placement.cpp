// Where pencils come to lie: outside solids, inside the space that film and lights share, anywhere in open scenes; and the laws that hold
// wherever they lie.
#include <algorithm>
#include <numeric>

#include "film/film.h"
#include "line/free_space.h"
#include "pencils/light_samples.h"
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"
#include "util/error.h"
#include "visibility/rasterize_octahedral.h"

namespace {

using namespace pencil;
using namespace pencil::test;

const Surface one_sided{glm::vec3(0.5F), glm::vec3(0.0F), false}, two_sided{glm::vec3(0.5F), glm::vec3(0.0F), true};

constexpr int map_size = 32;

/// A scene on the device with what places pencils in it.
class Placed {
public:
    Placed(const Scene& scene, const std::vector<Placement>& mixture, std::uint64_t seed = 0)
        : scene_(scene),
          forms_(scene.shapes.size(), LightForm::samples),
          flat_(flatten(scene_, forms_, 0, 0)),
          kernels_(device(), scene_features(flat_, RenderOptions().film_samples, false)),
          on_device_(device(), flat_, build_bvh(flat_.triangles)),
          film_(kernels_, on_device_, FilmCamera{flat_.camera, glm::vec3(flat_.eye)}, scene_.sensor.filter, Turn()),
          source_(make_candidate_source({kernels_, on_device_, scene_, flat_, seed}, mixture)) {
        const std::vector<LightSample> samples = sample_lights(scene_, flat_, forms_, 4, 0);
        if (!samples.empty()) {
            lights_ = LightSet(device(), samples, map_size);
            rasterize_octahedral(kernels_, on_device_, lights_.maps, 0, lights_.maps.count);
        }
        space_ =
            std::make_unique<FreeSpace>(kernels_, on_device_, flat_, film_.surfels(), samples.empty() ? nullptr : &lights_.maps, map_size);
    }

    /// Centres of the next set in world units; sets are made in order.
    std::vector<dvec3> next_set(int count) { return to_world(space_->create(kernels_, *source_, count, set_++)->cops.read()); }
    /// Candidates by themselves.
    std::vector<dvec3> candidates(int first, int count) { return to_world(source_->place({0, first, count, {}})); }
    std::string describe() const { return source_->describe(); }

private:
    std::vector<dvec3> to_world(const std::vector<float4>& centres) const {
        std::vector<dvec3> out;
        out.reserve(centres.size());
        for (const float4& c : centres) out.push_back(flat_.normalisation.to_world(dvec3(c)));
        return out;
    }

    Scene scene_;
    std::vector<LightForm> forms_;
    FlatScene flat_;
    Kernels kernels_;
    DeviceScene on_device_;
    Film film_;
    std::unique_ptr<CandidateSource> source_;
    LightSet lights_;
    std::unique_ptr<FreeSpace> space_;
    int set_ = 0;
};

std::vector<dvec3> centres(const Scene& scene, int count) { return Placed(scene, {Placement::lds}).next_set(count); }

/// Closed room that is no box: an inward pyramid over the unit square with its apex at (0.5, 1, 0.5), a third of its bounding box.
std::vector<Face> pyramid() {
    const dvec3 a(0, 0, 0), b(1, 0, 0), c(1, 0, 1), d(0, 0, 1), apex(0.5, 1, 0.5);
    return {{a, c, b}, {a, d, c}, {a, b, apex}, {b, c, apex}, {c, d, apex}, {d, a, apex}};
}

bool in_pyramid(const dvec3& p) { return std::max(std::abs(p.x - 0.5), std::abs(p.z - 0.5)) <= 0.5 * (1.0 - p.y); }

TEST(Placement, PencilsStayInsideAClosedRoom) {
    for (const Surface& surface : {one_sided, two_sided}) {
        Scene scene;
        add_shape(scene, "room", pyramid(), surface);
        look_at(scene, {0.3, 0.2, 0.3}, {0.7, 0.3, 0.7}, {0, 1, 0}, 60.0, 16, 16);
        const std::vector<dvec3> found = centres(scene, 64);
        ASSERT_EQ(found.size(), 64U);
        for (const dvec3& c : found) EXPECT_TRUE(in_pyramid(c)) << c.x << " " << c.y << " " << c.z;
    }
}

TEST(Placement, OpenSceneKeepsAllCandidates) {
    Scene scene;
    add_quad(scene, "floor", {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, one_sided);
    add_quad(scene, "sheet", {-0.2, 0.3, -1}, {0, 0.7, 0}, {0, 0, 2}, two_sided);
    look_at(scene, {-0.9, 0.5, 0}, {0, 0.3, 0}, {0, 1, 0}, 60.0, 16, 16);
    EXPECT_EQ(centres(scene, 64), Placed(scene, {Placement::lds}).candidates(0, 64));
}

/// Two unit rooms of their own shapes, side by side with a gap of 0.2; a passage of 0.4 x 0.4 through the gap, or none.
Scene separate_rooms(bool passage) {
    Scene scene;
    for (int room = 0; room < 2; ++room) {
        const dvec3 low(room == 0 ? 0.0 : 1.2, 0, 0), high = low + dvec3(1.0);
        for (int wall = 0; wall < 6; ++wall)
            if (wall != 1 - room) add_wall(scene, wall, low, high, one_sided);
        const double x = room == 0 ? 1.0 : 1.2;
        const auto piece = [&](double y0, double y1, double z0, double z1) {
            const dvec3 corner(x, y0, z0), up(0, y1 - y0, 0), along(0, 0, z1 - z0);
            add_quad(scene, "piece", corner, room == 0 ? along : up, room == 0 ? up : along, one_sided);
        };
        if (!passage) {
            piece(0, 1, 0, 1);
            continue;
        }
        piece(0, 1, 0, 0.3);
        piece(0, 1, 0.7, 1);
        piece(0, 0.3, 0.3, 0.7);
        piece(0.7, 1, 0.3, 0.7);
    }
    if (passage)
        for (const int wall : {2, 3, 4, 5}) add_wall(scene, wall, {1.0, 0.3, 0.3}, {1.2, 0.7, 0.7}, one_sided);
    look_at(scene, {0.1, 0.5, 0.1}, {0.4, 0.4, 0.9}, {0, 1, 0}, 30.0, 16, 16);  // sees walls of the first room only
    return scene;
}

int in_second_room(const std::vector<dvec3>& found) {
    int count = 0;
    for (const dvec3& c : found) count += c.x > 1.2 ? 1 : 0;
    return count;
}

TEST(Placement, RoomsThatAreConnectedBothGetPencils) {
    const std::vector<dvec3> found = centres(separate_rooms(true), 64);
    EXPECT_GT(in_second_room(found), 16);
    EXPECT_LT(in_second_room(found), 48);
}

TEST(Placement, ASealedRoomGetsPencilsOnlyWithALight) {
    Scene scene = separate_rooms(false);
    EXPECT_EQ(in_second_room(centres(scene, 64)), 0);
    scene.point_lights.push_back({{1.7, 0.5, 0.5}, glm::vec3(1.0F)});
    EXPECT_GT(in_second_room(centres(scene, 64)), 16);
}

/// Closed room with a solid block of these surfaces on its floor.
Scene room_with_block(const Surface& surface) {
    Scene scene;
    add_box(scene, dvec3(0.0), dvec3(1.0), one_sided);
    std::vector<Face> block;  // an upright prism over the triangle (0.2, 0.2), (0.8, 0.2), (0.5, 0.8) of the floor, fronts outwards
    const dvec3 foot[3] = {{0.2, 0, 0.2}, {0.8, 0, 0.2}, {0.5, 0, 0.8}}, up(0, 0.7, 0);
    for (int k = 0; k < 3; ++k) {
        const dvec3 p = foot[k], q = foot[(k + 1) % 3];
        block.push_back({p, p + up, q + up});
        block.push_back({p, q + up, q});
    }
    block.push_back({foot[0] + up, foot[2] + up, foot[1] + up});
    add_shape(scene, "block", block, surface);
    look_at(scene, {0.1, 0.8, 0.1}, {0.5, 0.4, 0.5}, {0, 1, 0}, 60.0, 16, 16);
    return scene;
}

void expect_free(const dvec3& c) {
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GT(c[axis], 0.0);  // false for what is not finite
        EXPECT_LT(c[axis], 1.0);
    }
    const double half = 0.3 * (0.8 - c.z) / 0.6;  // half width of the block at this z
    EXPECT_FALSE(c.y < 0.7 && c.z > 0.2 && std::abs(c.x - 0.5) < half) << c.x << " " << c.y << " " << c.z;
}

TEST(Placement, SolidsStayEmpty) {
    for (const Surface& surface : {one_sided, two_sided}) {
        const std::vector<dvec3> found = centres(room_with_block(surface), 64);
        ASSERT_EQ(found.size(), 64U);
        for (const dvec3& c : found) expect_free(c);
    }
}

TEST(Placement, ASceneWithoutAVisibleSurfaceStillGetsPencils) {
    Scene scene;
    add_quad(scene, "floor", {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, one_sided);
    look_at(scene, {0, 1, 0}, {0, 2, 0}, {0, 0, 1}, 60.0, 16, 16);  // looks away
    EXPECT_EQ(centres(scene, 8).size(), 8U);
}

/// Rooms side by side as `two_rooms` of known_scenes.h, a point light in the first, the camera in the second.
TEST(Placement, LightRaysStayInTheRoomOfTheLight) {
    Scene scene = two_rooms(0.0, false);
    Placed placed(scene, {Placement::light_rays});
    for (int set = 0; set < 3; ++set) {
        const std::vector<dvec3> found = placed.next_set(64);
        ASSERT_EQ(found.size(), 64U);
        for (const dvec3& c : found) EXPECT_LT(c.x, 1.0) << "set " << set;
    }
}

TEST(Placement, AMixtureIsTheUnionOfItsMembers) {
    const Scene scene = room_with_block(one_sided);
    const std::vector<dvec3> a = Placed(scene, {Placement::lds}).candidates(0, 20);
    const std::vector<dvec3> b = Placed(scene, {Placement::near_surface}).candidates(0, 20);
    Placed mixed(scene, {Placement::lds, Placement::near_surface});
    const std::vector<dvec3> both = mixed.candidates(0, 40);
    for (std::size_t i = 0; i < 40; ++i) EXPECT_EQ(both[i], (i % 2 == 0 ? a : b)[i / 2]) << i;
    const std::vector<dvec3> part = mixed.candidates(7, 5);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(part[i], both[7 + i]) << "candidate " << 7 + i;
    EXPECT_EQ(mixed.describe(), "lds + near-surface in equal parts");
}

TEST(Placement, WrongMixturesAreRefused) {
    const Scene scene = room_with_block(one_sided);
    EXPECT_THROW(Placed(scene, {}), UsageError);
    EXPECT_THROW(Placed(scene, {Placement::lds, Placement::profile, Placement::lds}), UsageError);
}

TEST(Placement, AnalyticWeightsNeedCentresSpreadEvenly) {
    RenderOptions options = line_options();
    options.weights = Weights::analytic;
    options.pencils = 4;
    options.placement = {Placement::lds, Placement::camera_rays};
    EXPECT_THROW(render_layers(furnace(0.5F), options), UsageError);
    options.placement = {Placement::lds, Placement::random};
    EXPECT_NO_THROW(render_layers(furnace(0.5F), options));
}

TEST(Placement, WithoutAStartTheBoxIsTaken) {
    const Scene unlit = room_with_block(one_sided);
    Placed light_rays(unlit, {Placement::light_rays});
    EXPECT_EQ(light_rays.candidates(0, 8), Placed(unlit, {Placement::lds}).candidates(0, 8));
    EXPECT_EQ(light_rays.describe(), "light-rays (no light: lds instead)");
    Scene empty;
    empty.point_lights.push_back({dvec3(1.0), glm::vec3(1.0F)});
    empty.point_lights.push_back({dvec3(2.0), glm::vec3(1.0F)});
    look_at(empty, {0, 0, 0}, {1, 1, 1}, {0, 1, 0}, 60.0, 4, 4);
    Placed near_surface(empty, {Placement::near_surface});
    EXPECT_EQ(near_surface.candidates(0, 8), Placed(empty, {Placement::lds}).candidates(0, 8));
    EXPECT_EQ(near_surface.describe(), "near-surface (no surface: lds instead)");
}

/// The profile prefers what sees much: a large room against a niche that shows little of it.
TEST(Placement, TheProfileLeavesNichesToFewer) {
    Scene scene;
    add_box(scene, dvec3(0.0), dvec3(1.0), one_sided);
    add_wall(scene, 1, dvec3(0.0), dvec3(0.5, 1, 1), two_sided);  // a wall in the middle, a gap above it
    for (glm::dvec3& p : scene.positions)
        if (p.x == 0.5) p.y = std::min(p.y, 0.9);
    add_wall(scene, 0, dvec3(0.8, 0, 0), dvec3(1.0), two_sided);  // and one that closes the rest: nothing looks in but pencils inside
    look_at(scene, {0.1, 0.5, 0.1}, {0.4, 0.4, 0.9}, {0, 1, 0}, 90.0, 16, 16);
    const auto in_niche = [](const std::vector<dvec3>& found) {
        return std::count_if(found.begin(), found.end(), [](const dvec3& c) { return c.x > 0.8; });
    };
    const auto by_box = in_niche(Placed(scene, {Placement::lds}).candidates(0, 200));
    const auto by_profile = in_niche(Placed(scene, {Placement::profile}).candidates(0, 200));
    EXPECT_NEAR(static_cast<double>(by_box), 40.0, 4.0);
    EXPECT_LT(by_profile, by_box - 8);
}

class EveryPlacement : public testing::TestWithParam<std::vector<Placement>> {};
INSTANTIATE_TEST_SUITE_P(Placement, EveryPlacement,
                         testing::Values(std::vector{Placement::random}, std::vector{Placement::lds}, std::vector{Placement::near_surface},
                                         std::vector{Placement::light_rays}, std::vector{Placement::camera_rays},
                                         std::vector{Placement::profile},
                                         std::vector{Placement::lds, Placement::near_surface, Placement::camera_rays}),
                         [](const auto& test) {
                             std::string name;
                             for (const Placement p : test.param) name += "placement" + std::to_string(static_cast<int>(p));
                             return name;
                         });

TEST_P(EveryPlacement, CentresAreFiniteAndInTheFreeSpace) {
    Scene scene = room_with_block(two_sided);
    scene.point_lights.push_back({{0.2, 0.9, 0.2}, glm::vec3(1.0F)});
    Placed placed(scene, GetParam());
    for (int set = 0; set < 3; ++set) {
        const std::vector<dvec3> found = placed.next_set(48);
        ASSERT_EQ(found.size(), 48U);
        for (const dvec3& c : found) expect_free(c);
    }
}

TEST_P(EveryPlacement, SeedAndSetDecideTheCentres) {
    Scene scene = room_with_block(two_sided);
    scene.point_lights.push_back({{0.2, 0.9, 0.2}, glm::vec3(1.0F)});
    Placed once(scene, GetParam()), again(scene, GetParam()), other(scene, GetParam(), 1);
    const std::vector<dvec3> first = once.next_set(24);
    EXPECT_EQ(first, again.next_set(24));
    EXPECT_NE(first, other.next_set(24));
    const std::vector<dvec3> second = once.next_set(24);
    EXPECT_EQ(second, again.next_set(24));
    for (std::size_t i = 0; i < 24; ++i) EXPECT_GT(glm::distance(first[i], second[i]), 1e-6) << "a new shift for each set";
}

RenderOptions small(const std::vector<Placement>& placement, Initial initial) {
    RenderOptions options = line_options();
    options.placement = placement;
    options.initial = initial;
    options.pencils = 48;
    options.map = 32;
    options.film_samples = 4;
    return options;
}

TEST_P(EveryPlacement, TheFurnaceIsExact) {
    RenderOptions options = small(GetParam(), Initial::emission);
    options.tolerance = 1e-4;
    expect_uniform(layer(render_layers(furnace(0.5F), options), ""), 2.0, 1e-3);
}

double mean_of(const Layer& image) {
    return std::accumulate(image.pixels.begin(), image.pixels.end(), 0.0) / static_cast<double>(image.pixels.size());
}

/// Where walls and partition meet in one point, pencils close to them light a surfel from behind now and then: measured up to 4e-7 of the
/// lit room's radiance with near-surface alone, 0 with all others. See corner_leak of test_darkness.cpp.
constexpr double near_leak = 1e-6;

TEST_P(EveryPlacement, NoLightPassesAPartition) {
    RenderOptions options = small(GetParam(), Initial::direct);
    options.bounces = 3;
    const auto& mixture = GetParam();
    const bool near = std::find(mixture.begin(), mixture.end(), Placement::near_surface) != mixture.end();
    for (const double thickness : {0.1, 0.004}) {
        for (const bool area : {false, true}) {
            SCOPED_TRACE(std::to_string(thickness) + (area ? " area" : " point"));
            Scene scene = two_rooms(thickness, area);
            const double dark = mean_of(layer(render_layers(scene, options), ""));
            look_at(scene, {0.1, 0.5, 0.1}, {1.0, 0.45, 0.9}, {0, 1, 0}, 90.0, 64, 64);
            const double lit = mean_of(layer(render_layers(scene, options), ""));
            EXPECT_GT(lit, 0.0);
            EXPECT_LE(dark, near ? near_leak * lit : 0.0);
        }
    }
}

}  // namespace
