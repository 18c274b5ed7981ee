// One material of a scene: as a row for kernels, and as the path tracer has it.
#pragma once

#include "kernels/bsdf_laws.h"
#include "pencils/material_rows.h"
#include "reference/bsdf.h"
#include "reference/surface_table.h"

namespace pencil::test {

class SceneRow {
public:
    SceneRow(const SceneMaterial& material, bool front) : scene_(with(material)), table_(scene_), front_(front) {}

    BsdfRow row() const {
        BsdfRow made;
        std::vector<Material> rows;
        std::vector<int> shapes;
        Triangle3 triangle{};
        MaterialRows(scene_, {LightForm::samples}, rows, shapes, made.tables, 1.0).of(triangle);
        made.row = rows.front();
        made.front = front_;
        return made;
    }
    const SurfaceMaterial& reference() const { return table_.side(SurfaceTable::number(0, front_)).material; }
    Scattering scattering() const {
        return [this](const dvec3& o, const dvec3& i) { return dvec3(evaluate(reference(), glm::vec3(o), glm::vec3(i))); };
    }

private:
    static Scene with(const SceneMaterial& material) {
        Scene scene;
        scene.materials = {material};
        scene.shapes.resize(1);
        return scene;
    }

    Scene scene_;
    SurfaceTable table_;
    bool front_;
};

}  // namespace pencil::test
