// Materials of an MTL library as materials of a scene.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "scene/file_search.h"
#include "scene/meshes/read_mtl.h"
#include "scene/problems.h"
#include "scene/scene.h"

namespace pencil {

/// Where pictures come from and problems go to.
struct MtlContext {
    const FileSearch& search;
    std::filesystem::path folder;
    std::string where;
    Problems& problems;
};

/// Appends the material, and before it those that it blends; the index of it. Pictures that cannot be read are left out with a warning, as
/// files of the web often lack some.
std::uint32_t add_mtl_material(const MtlMaterial& material, const MtlContext& context, Scene& scene);

/// What surfaces of the material emit.
void set_mtl_emission(const MtlMaterial& material, const MtlContext& context, Scene& scene, Shape& shape);

/// Says that what `error` is about is left out, or fails for it, as the problems have it.
void leave_out(const SceneError& error, const std::string& consequence, const std::string& where, Problems& problems);

/// The material of faces that name none.
SceneMaterial unnamed_material();

}  // namespace pencil
