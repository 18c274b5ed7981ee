// Rows of materials as kernels see them, and the textures that they name.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "pencils/light_form.h"
#include "scene/scene.h"
#include "shared/material.h"
#include "shared/texture.h"

namespace pencil {

/// Rows are made as triangles need them. What emits shares none: its radiance, the form of its light and the area that its samples stand
/// for are its own.
class MaterialRows {
public:
    MaterialRows(const Scene& scene, const std::vector<LightForm>& forms, std::vector<Material>& rows, std::vector<int>& shapes,
                 std::vector<std::uint64_t>& texels, double scale, double light = 1.0)
        : scene_(scene), forms_(forms), rows_(rows), shapes_(shapes), texels_(texels), scale_(scale), light_(light) {}

    /// Index of the triangle's row.
    int of(const Triangle3& t) { return row(t.material, scene_.shapes[t.shape].emits ? static_cast<std::int64_t>(t.shape) : -1, false); }

private:
    bool lets_light_pass(const SceneMaterial& m) const;
    int row(std::size_t material, std::int64_t emitter, bool two_sided);

    const Scene& scene_;
    const std::vector<LightForm>& forms_;
    std::vector<Material>& rows_;
    std::vector<int>& shapes_;            // that rows are of, if they emit, else -1
    std::vector<std::uint64_t>& texels_;  // of textures and tables
    double scale_;                        // world units per scene unit
    double light_;                        // unit of radiance
    std::map<std::tuple<std::size_t, std::int64_t, bool>, int> made_;
};

/// Textures in the order of the scene's, their texels behind those that are there: rgb and opacity, half floats.
std::vector<TextureRow> flatten_textures(const Scene& scene, std::vector<std::uint64_t>& texels);

}  // namespace pencil
