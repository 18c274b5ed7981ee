#include "film/approximations.h"

#include <algorithm>

namespace pencil {

namespace {

template <typename T, typename Holds>
bool any(const std::vector<T>& all, Holds holds) {
    return std::any_of(all.begin(), all.end(), holds);
}

}  // namespace

std::vector<std::string> approximations(const Scene& scene, const MethodNeeds& needs) {
    std::vector<std::string> found;
    const auto say = [&](bool holds, const char* sentence) {
        if (holds) found.emplace_back(sentence);
    };
    const auto& materials = scene.materials;
    say(any(
            materials, [](const SceneMaterial& m) { return m.alpha.x != m.alpha.y || m.principled.anisotropic > 0; }),
        "roughness that differs by direction counts as the same in all: the mean of both");
    say(any(
            materials, [](const SceneMaterial& m) { return m.transmitted_texture != no_texture; }),
        "textures of what glass lets through are left out");
    say(!needs.lobes && any(materials, [](const SceneMaterial& m) { return m.model != MATERIAL_DIFFUSE && m.model != MATERIAL_BLEND; }),
        "line projection reflects mirrors, glass and gloss evenly in all directions; --method surface follows them");
    return found;
}

}  // namespace pencil
