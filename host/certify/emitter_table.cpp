#include "certify/emitter_table.h"

#include <algorithm>

#include "image/colour.h"
#include "pencils/flat_sky.h"
#include "scene/light_chances.h"

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

/// Emitters and their power: luminance of radiance times area [scene units^2]. A light has one or more of them.
class Powers {
public:
    void add(const Emitter& emitter, double power, std::size_t light) {
        if (!(power > 0)) return;
        emitters.push_back(emitter);
        powers_.push_back(power);
        lights_.push_back(light);
        of_light_.resize(std::max(of_light_.size(), light + 1), 0.0);
        of_light_[light] += power;
    }
    /// Chances, when all are there.
    void write_chances() {
        for (const double power : of_light_) chances_.add(power);
        double up_to = 0;
        for (std::size_t i = 0; i < emitters.size(); ++i) {
            const double chance = powers_[i] * per_power(lights_[i]);
            emitters[i].chance = static_cast<float>(chance);
            emitters[i].emission.w = static_cast<float>(up_to += chance);
        }
    }
    /// Chance of an emitter of a light for each unit of its power.
    double per_power(std::size_t light) const {
        return light < of_light_.size() && of_light_[light] > 0 ? chances_.per_power(of_light_[light]) : 0;
    }

    std::vector<Emitter> emitters;

private:
    std::vector<double> powers_, of_light_;
    std::vector<std::size_t> lights_;
    LightChances chances_;
};

}  // namespace

EmitterTable tabulate_emitters(const Scene& scene, const FlatScene& flat) {
    Powers powers;
    const auto radiance = [&](std::size_t row) { return luminance(glm::dvec3(flat.materials[row].emission)); };
    for (std::size_t i = 0; i < flat.triangles.size(); ++i) {
        const Triangle& t = flat.triangles[i];
        powers.add(triangle_emitter(static_cast<int>(i)), radiance(static_cast<std::size_t>(t.material)) * glm::length(area_vector(t)),
                   static_cast<std::size_t>(t.shape));
    }
    auto light = static_cast<std::size_t>(flat.shape_count);
    for (std::size_t i = 0; i < scene.point_lights.size(); ++i) {
        const Emitter emitter = point_emitter(scene.point_lights[i], flat.profile_tables[i], flat.normalisation);
        powers.add(emitter, sphere_area * luminance(glm::dvec3(emitter.emission)), light++);
    }
    const double sky_area = cross_section(flat);
    for (const DirectionalLight& parallel : scene.directional_lights) {
        const Emitter emitter = parallel_emitter(parallel, flat.normalisation);
        powers.add(emitter, sky_area * luminance(glm::dvec3(emitter.emission)), light++);
    }
    for (std::size_t i = 0; i < flat.sky_texels.size(); ++i) {
        const int column = static_cast<int>(i) % flat.sky.width, row = static_cast<int>(i) / flat.sky.width;
        powers.add(sky_emitter(column, row), sky_area * sampled_texel_power(flat.sky, flat.sky_texels, i), light);
    }
    powers.write_chances();
    EmitterTable table{std::move(powers.emitters), {}, sky_area * powers.per_power(light)};
    for (std::size_t row = 0; row < flat.materials.size(); ++row) {
        const int shape = flat.row_shapes[row];
        const double density = shape < 0 ? 0 : radiance(row) * powers.per_power(static_cast<std::size_t>(shape));
        table.densities.push_back(static_cast<float>(density));
    }
    return table;
}

}  // namespace pencil
