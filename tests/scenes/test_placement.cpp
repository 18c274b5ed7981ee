// Where pencils come to lie: outside solids, inside the space that film and lights share, anywhere in open scenes.
#include "pencils/light_samples.h"
#include "pencils/place_pencils.h"
#include "scenes/scene_builder.h"
#include "transport/film.h"
#include "transport/free_space.h"
#include "transport/rasterize_octahedral.h"

namespace {

using namespace pencil;
using namespace pencil::test;

const Surface one_sided{glm::vec3(0.5F), glm::vec3(0.0F), false}, two_sided{glm::vec3(0.5F), glm::vec3(0.0F), true};

constexpr int map_size = 32;

/// Centres of set 0 in world units.
std::vector<dvec3> centres(const Scene& scene, int count) {
    const std::vector<LightForm> forms(scene.shapes.size(), LightForm::samples);
    const FlatScene flat = flatten(scene, forms, 0, 0);
    Kernels kernels(device(), detect_features(flat, RenderOptions()));
    const DeviceScene on_device(device(), flat);
    const Film film(kernels, on_device, flat.camera, scene.sensor.filter, 0);
    const std::vector<LightSample> samples = sample_lights(scene, flat, forms, 4, 0);
    LightSet lights;
    if (!samples.empty()) {
        lights = LightSet(device(), samples, map_size);
        rasterize_octahedral(kernels, on_device, lights.maps, 0, lights.maps.count);
    }
    FreeSpace space(kernels, on_device, flat, film.surfels(), samples.empty() ? nullptr : &lights.maps, map_size);
    std::vector<dvec3> out;
    for (const float4& c : space.create(kernels, Sequence::low_discrepancy, count, 0, 0)->cops.read())
        out.push_back(flat.normalisation.to_world(dvec3(c)));
    return out;
}

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
    const std::vector<dvec3> found = centres(scene, 64);
    const FlatScene flat = flatten(scene, std::vector<LightForm>(2, LightForm::samples), 0, 0);
    const std::vector<float4> candidates = place_pencils(flat, Sequence::low_discrepancy, 0, 64, 0, 0);
    ASSERT_EQ(found.size(), candidates.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i], flat.normalisation.to_world(dvec3(candidates[i]))) << i;
}

/// Two unit rooms of their own shapes, side by side with a gap of 0.2; a passage of 0.4 x 0.4 through the gap, or none.
Scene two_rooms(bool passage) {
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
    const std::vector<dvec3> found = centres(two_rooms(true), 64);
    EXPECT_GT(in_second_room(found), 16);
    EXPECT_LT(in_second_room(found), 48);
}

TEST(Placement, ASealedRoomGetsPencilsOnlyWithALight) {
    Scene scene = two_rooms(false);
    EXPECT_EQ(in_second_room(centres(scene, 64)), 0);
    scene.point_lights.push_back({{1.7, 0.5, 0.5}, glm::vec3(1.0F)});
    EXPECT_GT(in_second_room(centres(scene, 64)), 16);
}

TEST(Placement, SolidsStayEmpty) {
    for (const Surface& surface : {one_sided, two_sided}) {
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
        const std::vector<dvec3> found = centres(scene, 64);
        ASSERT_EQ(found.size(), 64U);
        for (const dvec3& c : found) {
            const double half = 0.3 * (0.8 - c.z) / 0.6;  // half width of the triangle at this z
            EXPECT_FALSE(c.y < 0.7 && c.z > 0.2 && std::abs(c.x - 0.5) < half) << c.x << " " << c.y << " " << c.z;
        }
    }
}

TEST(Placement, ASceneWithoutAVisibleSurfaceStillGetsPencils) {
    Scene scene;
    add_quad(scene, "floor", {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, one_sided);
    look_at(scene, {0, 1, 0}, {0, 2, 0}, {0, 0, 1}, 60.0, 16, 16);  // looks away
    EXPECT_EQ(centres(scene, 8).size(), 8U);
}

}  // namespace
