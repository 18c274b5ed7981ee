// A scene with lobes on the device, with its film.
#pragma once

#include "film/film.h"
#include "kernels/kernel_test.h"
#include "pencils/light_samples.h"
#include "reference/bsdf.h"
#include "reference/surface_table.h"
#include "scenes/scene_parts.h"
#include "surface/follow_surfels.h"

namespace pencil::test {

struct LobeScene {
    explicit LobeScene(const Scene& made)
        : scene(made),
          forms(choose_light_forms(scene, true, false)),
          flat(flatten(scene, forms, 0, 0)),
          kernels(device(), features_of(flat)),
          on_device(device(), flat, build_bvh(flat.triangles)),
          film(kernels, on_device, FilmCamera{flat.camera, glm::vec3(flat.eye)}, scene.sensor.filter, Turn{}),
          seen(film.surfels()),
          no_lights{Buffer<float>(device(), std::vector<float>(flat.materials.size(), HUGE_VALF), "no light samples"), 0.0F} {}

    dvec3 world(const HostSurfels& surfels, int i) const { return flat.normalisation.to_world(surfels.position(i)); }
    dvec3 eye() const { return dvec3(scene.sensor.to_world[3]); }
    /// Surfels of the film on materials of this model.
    std::vector<int> on(int model) const {
        std::vector<int> out;
        for (int i = 0; i < seen.count; ++i) {
            if (seen.plane(i) < 0) continue;
            const int row = seen.material(i);
            if (flat.materials[static_cast<std::size_t>(row < 0 ? ~row : row)].model == model) out.push_back(i);
        }
        return out;
    }
    /// Ends of chains that start there, `shared` of them on the same surfel.
    HostSurfels follow(const std::vector<int>& starts, int shared = 1) {
        return HostSurfels(follow_surfels(kernels, on_device, film.surfels(), Buffer<int>(device(), starts, "starts"), {shared, false},
                                          {no_lights, no_lights}, 7)
                               .ends);
    }

    Scene scene;
    std::vector<LightForm> forms;
    FlatScene flat;
    Kernels kernels;
    DeviceScene on_device;
    Film film;
    HostSurfels seen;
    LobeLights no_lights;

private:
    static Features features_of(const FlatScene& flat) {
        Features features = scene_features(flat, 4, true);
        features.bvh = true;
        return features;
    }
};

}  // namespace pencil::test
