#include "surface/small_lights.h"

#include <algorithm>
#include <limits>

#include "util/constants.h"

namespace pencil {

namespace {

/// Of all lights together, and of a lamp.
constexpr std::size_t most_probes = 64, lamp_probes = 8;

double sum_of(const float4& rgb) { return static_cast<double>(rgb.x) + static_cast<double>(rgb.y) + static_cast<double>(rgb.z); }

/// Its two probes stand back to back.
SmallLight point_light(const LightSample& sample) {
    const glm::vec3 place(sample.position);
    return {{place, place}, {{0, 0, 1}, {0, 0, -1}}, {-1, -1}, 0, 4 * pi * sum_of(sample.emission)};
}

/// The lamp of these triangles, with probes at the middles of some of them.
SmallLight lamp(const FlatScene& flat, const std::vector<const Triangle*>& triangles) {
    SmallLight light;
    glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
    double area = 0;
    for (const Triangle* t : triangles) {
        area += glm::length(area_vector(*t));
        for (const float4& v : {t->v0, t->v1, t->v2}) {
            low = glm::min(low, glm::dvec3(v));
            high = glm::max(high, glm::dvec3(v));
        }
    }
    light.extent = static_cast<float>(glm::distance(low, high));
    light.strength = pi * area * sum_of(flat.materials[static_cast<std::size_t>(triangles.front()->material)].emission);
    const std::size_t probes = std::min(triangles.size(), lamp_probes);
    for (std::size_t k = 0; k < probes; ++k) {
        const Triangle& t = *triangles[k * triangles.size() / probes];
        light.places.push_back(glm::vec3(glm::dvec3(t.v0) + glm::dvec3(t.v1) + glm::dvec3(t.v2)) / 3.0F);
        light.normals.emplace_back(flat.planes[static_cast<std::size_t>(t.plane)]);
        light.planes.push_back(t.plane);
    }
    return light;
}

std::vector<SmallLight> lamps(const RenderContext& context) {
    std::vector<SmallLight> lights;
    std::vector<const Triangle*> triangles;
    const auto end_shape = [&] {
        if (!triangles.empty()) lights.push_back(lamp(context.flat, triangles));
        triangles.clear();
    };
    for (const Triangle& t : context.flat.triangles) {
        const auto shape = static_cast<std::size_t>(t.shape);
        if (!context.scene.shapes[shape].emits || context.forms[shape] != LightForm::samples) continue;
        if (!triangles.empty() && triangles.back()->shape != t.shape) end_shape();
        triangles.push_back(&t);
    }
    end_shape();
    return lights;
}

}  // namespace

std::vector<SmallLight> small_lights(const RenderContext& context, const std::vector<LightSample>& samples) {
    std::vector<SmallLight> lights = lamps(context);
    for (const LightSample& s : samples)
        if (s.position.w != LIGHT_AREA && s.position.w != LIGHT_INFINITE) lights.push_back(point_light(s));
    std::stable_sort(lights.begin(), lights.end(), [](const SmallLight& a, const SmallLight& b) { return a.strength > b.strength; });
    std::size_t probes = 0, count = 0;
    while (count < lights.size() && (probes += lights[count].places.size()) <= most_probes) ++count;
    lights.resize(count);
    return lights;
}

SurfacePencils probes_of(const std::shared_ptr<Device>& device, const std::vector<SmallLight>& lights) {
    std::vector<SurfacePencil> probes;
    for (const SmallLight& light : lights)
        for (std::size_t k = 0; k < light.places.size(); ++k) {
            SurfacePencil probe{};
            probe.position = float4(light.places[k], 0.0F);
            probe.normal = probe.facing = float4(light.normals[k], 0.0F);
            probe.plane = light.planes[k];
            probe.key = static_cast<uint>(probes.size());
            probes.push_back(probe);
        }
    return {device, probes, probe_map};
}

}  // namespace pencil
