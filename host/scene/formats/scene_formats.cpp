// The table of formats. A new one is a folder beside scene/mitsuba, a line in CMakeLists.txt and a row here: docs/adding_a_format.md.
#include "scene/formats/other_formats.h"
#include "scene/formats/scene_format.h"
#include "scene/mitsuba/read_mitsuba.h"
#include "scene/xml_head.h"

namespace pencil {
namespace {

constexpr const char* mesh_alone = "a mesh alone has no camera and no light; ";
constexpr const char* by_blender = "it cannot be read; open it in Blender and export it as Mitsuba XML, with the add-on mitsuba-blender";
constexpr const char* no_image = "an image is no scene; \"pencil compare\" takes images";

std::string name_it(const std::string& type) { return std::string(mesh_alone) + "name it in a scene: <shape type=\"" + type + "\">"; }

}  // namespace

const std::vector<SceneFormat>& scene_formats() {
    static const std::vector<SceneFormat> formats = {
        {"PLY", is_ply, nullptr, name_it("ply")},
        {"OBJ", is_obj, nullptr, name_it("obj")},
        {"glTF", is_gltf, nullptr, by_blender},
        {"USD", is_usd, nullptr, by_blender},
        {"FBX", is_fbx, nullptr, by_blender},
        {"COLLADA", is_collada, nullptr, by_blender},
        {"Alembic", is_alembic, nullptr, by_blender},
        {"Blender", is_blender, nullptr, by_blender},
        {"pbrt", is_pbrt, nullptr, "it cannot be read; many scenes for pbrt are published as Mitsuba XML, too"},
        {"PNG", is_png, nullptr, no_image},
        {"OpenEXR", is_exr, nullptr, no_image},
        {"Radiance HDR", is_hdr, nullptr, no_image},
        {"STL", is_stl, nullptr, std::string(mesh_alone) + "convert it to PLY and name that in a scene: <shape type=\"ply\">"},
        {"Mitsuba XML", is_xml, read_mitsuba, {}, ".xml"},  // last: any XML that is nothing else
    };
    return formats;
}

}  // namespace pencil
