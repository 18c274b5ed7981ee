// Materials of an OBJ's libraries as Mitsuba 0.x reads them: rewritten as the <bsdf> elements of its own that it makes of them
// (loadMaterialLibrary and addMaterial in its src/shapes/obj.cpp).
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "scene/meshes/mesh.h"
#include "scene/mitsuba/xml_source.h"

namespace pencil {

class MtlBsdfs {
public:
    explicit MtlBsdfs(XmlSource& source) : source_(source) {}

    /// Of all libraries that the mesh, a file in `folder`, names; the first of a name counts. What cannot be read is left out, with a warning
    /// at `shape`.
    std::map<std::string, pugi::xml_node> of(const Mesh& mesh, const std::filesystem::path& folder, pugi::xml_node shape);

private:
    using Library = std::map<std::string, pugi::xml_node>;
    const Library& library(const std::string& name, const std::filesystem::path& folder, pugi::xml_node shape);
    Library read(const std::filesystem::path& file, pugi::xml_node shape);

    XmlSource& source_;
    std::map<std::filesystem::path, Library> libraries_;
};

}  // namespace pencil
