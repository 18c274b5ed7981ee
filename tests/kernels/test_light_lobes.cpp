// Lobes under light samples against the path tracer's model.
#include "kernels/lobe_test.h"
#include "surface/emit_chains.h"
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
    light_lobes(room.kernels, room.on_device, room.film.surfels(), Buffer<int>(device(), chosen, "chosen"), 1, lights, outgoing);
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

/// A metal wall under a square lamp, of which light samples and chains carry a share each.
struct LampBesideMetal {
    LampBesideMetal() : room(make()), chosen(room.on(MATERIAL_CONDUCTOR)) {}

    static Scene make() {
        Scene scene;
        add_box(scene, dvec3(0.0), dvec3(1.0), Surface{glm::vec3(0.5F)});
        SceneMaterial& metal = scene.materials[1];  // at x = 1
        metal.model = MATERIAL_CONDUCTOR;
        metal.alpha = glm::vec2(0.15F);
        metal.eta = glm::vec3(0.2F, 0.9F, 1.4F);
        metal.k = glm::vec3(3.9F, 2.4F, 1.6F);
        add_quad(scene, "lamp", corner, edge_y, edge_z, {glm::vec3(0.0F), radiance, false});
        look_at(scene, {0.3, 0.2, 0.5}, {1.0, 0.3, 0.5}, {0, 1, 0}, 50.0, 12, 12);
        return scene;
    }

    /// Mean over the film's surfels on the wall, by quadrature over the lamp.
    dvec3 exact() const {
        constexpr int steps = 48;
        const SurfaceTable table(room.scene);
        const auto& metal = table.side(SurfaceTable::number(1, true)).material;
        const double area = glm::length(edge_y) * glm::length(edge_z);
        const auto local = [](const dvec3& v) { return glm::vec3(v.y, v.z, -v.x); };
        dvec3 sum(0.0);
        for (const int i : chosen) {
            const dvec3 p = room.world(room.seen, i), to_eye = glm::normalize(room.eye() - p);
            for (int a = 0; a < steps; ++a)
                for (int b = 0; b < steps; ++b) {
                    const dvec3 step = corner + (a + 0.5) / steps * edge_y + (b + 0.5) / steps * edge_z - p, d = glm::normalize(step);
                    const double form = std::abs(d.x);  // the lamp's normal is x
                    const dvec3 f = evaluate(metal, local(to_eye), local(d));
                    sum += f * dvec3(radiance) * form * area / (steps * steps * glm::dot(step, step));
                }
        }
        return sum / static_cast<double>(chosen.size());
    }

    /// The same by the kernels, with so many chains for each surfel.
    dvec3 rendered(int chains) {
        constexpr int turns = 40;
        std::vector<int> starts;
        for (const int i : chosen) starts.insert(starts.end(), static_cast<std::size_t>(chains), i);
        Buffer<float> outgoing = surfel_rgb(device(), static_cast<int>(room.seen.capacity), "outgoing");
        dvec3 sum(0.0);
        for (std::uint64_t turn = 0; turn < turns; ++turn) {
            const std::vector<LightSample> samples = sample_lights(room.scene, room.flat, room.forms, 12, 5, turn);
            light_lobes(room.kernels, room.on_device, room.film.surfels(), Buffer<int>(device(), chosen, "chosen"), chains,
                        LightSet(device(), samples, 0), outgoing);
            const LobeLights near{Buffer<float>(device(), near_areas(room.flat, samples), "near areas"), 0.0F};
            const Chains ends = follow_surfels(room.kernels, room.on_device, room.film.surfels(), Buffer<int>(device(), starts, "starts"),
                                               {chains, true}, {near, near}, static_cast<uint>(turn + 1));
            Buffer<float> carried = surfel_rgb(device(), ends.ends.capacity, "radiance of chains");
            emit_chains(room.kernels, room.on_device, ends.ends, carried);
            const std::vector<float> light = carried.read();
            for (int k = 0; k < static_cast<int>(starts.size()); ++k)
                sum += rgb_at(light, static_cast<std::size_t>(ends.ends.capacity), k) / static_cast<double>(chains);
        }
        const std::vector<float> direct = outgoing.read();
        for (const int i : chosen) sum += rgb_at(direct, room.seen.capacity, i);
        return sum / (static_cast<double>(turns) * static_cast<double>(chosen.size()));
    }

    static constexpr dvec3 corner{0.4, 0.5, 0.3}, edge_y{0, 0.3, 0}, edge_z{0, 0, 0.4};
    static constexpr glm::vec3 radiance{3.0F, 2.0F, 1.0F};
    LobeScene room;
    std::vector<int> chosen;
};

TEST(LightLobes, SamplesAndAnyNumberOfChainsCarryAllLight) {
    LampBesideMetal lamp;
    ASSERT_GT(lamp.chosen.size(), 100U);
    const dvec3 exact = lamp.exact();
    for (const int chains : {1, 4, 16}) expect_close(lamp.rendered(chains), exact, 1e-2, std::to_string(chains) + " chains");
}

}  // namespace
