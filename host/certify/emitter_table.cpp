#include "certify/emitter_table.h"

#include "image/colour.h"

namespace pencil {

namespace {

/// Intensity of a uniform sphere of radiance L and area A is L A / 4.
constexpr double sphere_area = 4;

Emitter triangle_emitter(int triangle) {
    Emitter e{};
    e.triangle = triangle;
    return e;
}

Emitter point_emitter(const PointLight& light, const Normalisation& normalisation) {
    Emitter e{};
    e.position = float4(glm::vec3(normalisation.to_scene(light.position)), 0.0F);
    e.emission = float4(glm::vec3(glm::dvec3(light.intensity) / (normalisation.scale * normalisation.scale)), 0.0F);
    e.triangle = -1;
    return e;
}

}  // namespace

EmitterTable tabulate_emitters(const Scene& scene, const FlatScene& flat) {
    EmitterTable table;
    std::vector<double> up_to;
    const auto add = [&](const Emitter& emitter, double power) {
        if (!(power > 0)) return;
        table.emitters.push_back(emitter);
        up_to.push_back(table.power += power);
    };
    for (std::size_t i = 0; i < flat.triangles.size(); ++i) {
        const Triangle& t = flat.triangles[i];
        add(triangle_emitter(static_cast<int>(i)),
            luminance(glm::dvec3(flat.materials[static_cast<std::size_t>(t.material)].emission)) * glm::length(area_vector(t)));
    }
    for (const PointLight& light : scene.point_lights) {
        const Emitter emitter = point_emitter(light, flat.normalisation);
        add(emitter, sphere_area * luminance(glm::dvec3(emitter.emission)));
    }
    for (std::size_t i = 0; i < up_to.size(); ++i) {
        table.emitters[i].chance = static_cast<float>((up_to[i] - (i > 0 ? up_to[i - 1] : 0.0)) / table.power);
        table.emitters[i].emission.w = static_cast<float>(up_to[i] / table.power);
    }
    return table;
}

}  // namespace pencil
