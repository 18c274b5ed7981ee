// Light samples for direct light: point samples of the emitters, stratified by power (thesis 6.1.3).
#pragma once

#include <vector>

#include "pencils/flat_scene.h"
#include "shared/light.h"

namespace pencil {

/// A point that light should reach, with the normal of its seen side.
struct LightReceiver {
    glm::vec3 position, normal;  // [scene units]
};

/// One sample per point light, and `count` (at least one per emitting shape) over the area emitters of form `samples`, in proportion
/// to their power. Radiance is unchanged by the scene's scale; intensities and areas are turned into scene units. Sets of one seed in
/// successive turns fill the emitters evenly. With `importance`, the triangles of an emitter get samples by this, and a few by their area.
std::vector<LightSample> sample_lights(const Scene& scene, const FlatScene& flat, const std::vector<LightForm>& forms, int count,
                                       std::uint64_t seed, std::uint64_t turn = 0, const std::vector<float>& importance = {});

/// Light that each triangle of an emitter of form `samples` would send to the receivers per area, if nothing stood between, of all alike radiance.
std::vector<float> light_importance(const Scene& scene, const FlatScene& flat, const std::vector<LightForm>& forms,
                                    const std::vector<LightReceiver>& receivers);

/// True if which triangle is sampled makes a difference: some emitter of form `samples` has more than a quad.
bool has_detailed_emitters(const Scene& scene, const FlatScene& flat, const std::vector<LightForm>& forms);

/// Per row of materials: area over pi that each light sample of an emitter stands for [scene units^2]; infinite where there are none. Light
/// samples carry the share r^2 / (r^2 + that) of the light to a point at distance r.
std::vector<float> near_areas(const FlatScene& flat, const std::vector<LightSample>& samples, double factor = 1);

/// `automatic` per emitting shape: an emitter of more than large_emitter of the scene's surface is carried by the maps, unless it is so far from
/// all that does not emit that it is small from there: its square distance more than far_emitter times its area. From there maps hardly see it.
std::vector<LightForm> choose_light_forms(const Scene& scene, bool all_samples, bool all_maps);
/// True if some emitter is carried by maps.
bool maps_carry_emitters(const Scene& scene, const std::vector<LightForm>& forms);

/// Share of the scene's surface above which point samples of an emitter lie too near what they light.
constexpr double large_emitter = 0.05;
constexpr double far_emitter = 2;

}  // namespace pencil
