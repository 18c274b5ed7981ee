// The table of formats. A new one is a folder beside scene/mitsuba, a line in CMakeLists.txt and a row here: docs/adding_a_format.md.
#include "scene/formats/other_formats.h"
#include "scene/formats/scene_format.h"
#include "scene/gltf/read_gltf.h"
#include "scene/mitsuba/read_mitsuba.h"
#include "scene/models/read_model.h"
#include "scene/xml_head.h"

namespace pencil {
namespace {

constexpr const char* by_blender = "it cannot be read; open it in Blender and export it as glTF";
constexpr const char* no_image = "an image is no scene; \"pencil compare\" takes images";

}  // namespace

const std::vector<SceneFormat>& scene_formats() {
    static const std::vector<SceneFormat> formats = {
        {"PLY", is_ply, read_ply_scene, {}, ".ply"},
        {"OBJ", is_obj, read_obj_scene, {}, ".obj"},
        {"glTF", is_gltf, read_gltf, {}, ".gltf"},
        {"USD", is_usd, nullptr, by_blender},
        {"FBX", is_fbx, nullptr, by_blender},
        {"COLLADA", is_collada, nullptr, by_blender},
        {"Alembic", is_alembic, nullptr, by_blender},
        {"Blender", is_blender, nullptr, by_blender},
        {"pbrt", is_pbrt, nullptr, "it cannot be read; many scenes for pbrt are published as Mitsuba XML, too"},
        {"PNG", is_png, nullptr, no_image},
        {"OpenEXR", is_exr, nullptr, no_image},
        {"Radiance HDR", is_hdr, nullptr, no_image},
        {"STL", is_stl, nullptr, "it cannot be read; convert it to PLY or OBJ"},
        {"Mitsuba XML", is_xml, read_mitsuba, {}, ".xml"},  // last: any XML that is nothing else
    };
    return formats;
}

}  // namespace pencil
