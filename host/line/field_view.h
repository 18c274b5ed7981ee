// A field of pencils in the maps of a set on the device: all of it, or a part that changes with the view.
#pragma once

#include <memory>
#include <vector>

#include "film/render_context.h"
#include "line/field_subset.h"
#include "line/free_space.h"
#include "line/pencil_solver.h"

namespace pencil {

class FieldView {
public:
    /// RenderOptions::field of the context, or field_pencils of it. All must outlive the view.
    FieldView(RenderContext& context, PencilSolver& solver, FreeSpace& space);

    /// Makes `set`, at first undefined, what a film of these surfels is to be lit by.
    void show(const Surfels& film, PencilSet& set);

private:
    void show_part(const Surfels& film, PencilSet& set);
    void light(const PencilField& field, PencilSet& set);

    RenderContext& context_;
    PencilSolver& solver_;
    FreeSpace& space_;
    std::vector<float4> centres_;  // of the whole field [scene units]
    std::unique_ptr<FieldSubset> subset_;
    double share_ = -1;  // with which the weights were made
    bool lit_ = false;
};

}  // namespace pencil
