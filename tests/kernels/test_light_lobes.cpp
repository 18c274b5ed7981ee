// Lobes under light samples against the path tracer's model.
#include "kernels/lobe_test.h"
#include "surface/light_lobes.h"

namespace {

using namespace pencil;
using namespace pencil::test;

TEST(LightLobes, APointLightOnAMetalWall) {
    Scene scene;
    add_box(scene, dvec3(0.0), dvec3(1.0), Surface{glm::vec3(0.5F)});
    SceneMaterial& metal = scene.materials[1];  // at x = 1
    metal.model = MATERIAL_CONDUCTOR;
    metal.alpha = glm::vec2(0.3F);
    metal.eta = glm::vec3(0.2F, 0.9F, 1.4F);
    metal.k = glm::vec3(3.9F, 2.4F, 1.6F);
    scene.point_lights.push_back({{0.4, 0.7, 0.6}, glm::vec3(3.0F, 2.0F, 1.0F)});
    look_at(scene, {0.3, 0.4, 0.5}, {1.0, 0.6, 0.45}, {0, 1, 0}, 60.0, 16, 16);
    LobeScene room(scene);
    const std::vector<int> chosen = room.on(MATERIAL_CONDUCTOR);
    ASSERT_GT(chosen.size(), 100U);
    const LightSet lights(device(), sample_lights(room.scene, room.flat, room.forms, 4, 0), 0);
    Buffer<float> outgoing = surfel_rgb(device(), static_cast<int>(room.seen.capacity), "outgoing");
    light_lobes(room.kernels, room.on_device, room.film.surfels(), Buffer<int>(device(), chosen, "chosen"), lights, outgoing);
    const std::vector<float> got = outgoing.read();
    const SurfaceTable table(room.scene);
    for (const int i : chosen) {
        const dvec3 p = room.world(room.seen, i), to_eye = glm::normalize(room.eye() - p), to_light = dvec3(0.4, 0.7, 0.6) - p;
        const auto local = [](const dvec3& v) { return glm::vec3(v.y, v.z, -v.x); };  // the wall's normal is -x
        const dvec3 f = evaluate(table.side(SurfaceTable::number(1, true)).material, local(to_eye), local(glm::normalize(to_light)));
        expect_close(rgb_at(got, room.seen.capacity, i), f * dvec3(3, 2, 1) / glm::dot(to_light, to_light), 2e-3,
                     "surfel " + std::to_string(i));
    }
    for (int i = 0; i < room.seen.count; ++i) {
        if (std::find(chosen.begin(), chosen.end(), i) != chosen.end()) continue;
        EXPECT_EQ(rgb_at(got, room.seen.capacity, i), dvec3(0.0));
    }
}

}  // namespace
