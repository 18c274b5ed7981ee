#include "certify/emitter_table.h"

#include "image/colour.h"
#include "pencils/flat_sky.h"

namespace pencil {

namespace {

/// Intensity of a uniform sphere of radiance L and area A is L A / 4.
constexpr double sphere_area = 4;

Emitter triangle_emitter(int triangle) {
    Emitter e{};
    e.triangle = triangle;
    return e;
}

Emitter point_emitter(const PointLight& light, int profile_table, const Normalisation& normalisation) {
    Emitter e{};
    e.position = float4(glm::vec3(normalisation.to_scene(light.position)), 0.0F);
    e.emission = float4(normalisation.to_light(glm::dvec3(light.intensity) / (normalisation.scale * normalisation.scale)), 0.0F);
    e.triangle = EMITTER_POINT;
    if (profile_table >= 0) {
        e.position.w = -1.0F - static_cast<float>(profile_table);
        e.axis = float4(glm::vec3(glm::normalize(glm::dvec3(light.to_world[2]))), 0.0F);
    } else if (light.is_spot) {
        constexpr double degree = 3.14159265358979323846 / 180;
        e.position.w = static_cast<float>(light.cutoff * degree);
        e.axis = float4(glm::vec3(glm::normalize(glm::dvec3(light.to_world[2]))), static_cast<float>(light.beam_width * degree));
    }
    return e;
}

Emitter parallel_emitter(const DirectionalLight& light, const Normalisation& normalisation) {
    Emitter e{};
    e.triangle = EMITTER_PARALLEL;
    e.emission = float4(normalisation.to_light(light.irradiance), 0.0F);
    e.axis = float4(glm::vec3(light.direction), 0.0F);
    return e;
}

Emitter sky_emitter(int column, int row) {
    Emitter e{};
    e.triangle = EMITTER_SKY;
    e.column = column;
    e.row = row;
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
    for (std::size_t i = 0; i < scene.point_lights.size(); ++i) {
        const Emitter emitter = point_emitter(scene.point_lights[i], flat.profile_tables[i], flat.normalisation);
        add(emitter, sphere_area * luminance(glm::dvec3(emitter.emission)));
    }
    table.sky_area = cross_section(flat);
    for (const DirectionalLight& light : scene.directional_lights) {
        const Emitter emitter = parallel_emitter(light, flat.normalisation);
        add(emitter, table.sky_area * luminance(glm::dvec3(emitter.emission)));
    }
    for (std::size_t i = 0; i < flat.sky_texels.size(); ++i) {
        const int column = static_cast<int>(i) % flat.sky.width, row = static_cast<int>(i) / flat.sky.width;
        add(sky_emitter(column, row), table.sky_area * sampled_texel_power(flat.sky, flat.sky_texels, i));
    }
    for (std::size_t i = 0; i < up_to.size(); ++i) {
        table.emitters[i].chance = static_cast<float>((up_to[i] - (i > 0 ? up_to[i - 1] : 0.0)) / table.power);
        table.emitters[i].emission.w = static_cast<float>(up_to[i] / table.power);
    }
    return table;
}

}  // namespace pencil
