#include "render/methods.h"

#include <stdexcept>

#include "line/line_method.h"
#include "surface/field_method.h"
#include "surface/surface_method.h"
#include "surface/surface_needs.h"

namespace pencil {

namespace {

template <typename M>
std::unique_ptr<Method> make(RenderContext& context) {
    return std::make_unique<M>(context);
}

/// A field is filled; line and hybrid show it.
std::unique_ptr<Method> make_surface(RenderContext& context) {
    return context.options.field ? make<FieldMethod>(context) : make<SurfaceMethod>(context);
}

constexpr MethodRow methods[] = {
    {MethodName::surface, surface_needs, make_surface},
    {MethodName::line, line_needs, make<LineMethod>},
    {MethodName::hybrid, line_needs, make<LineMethod>},
};

}  // namespace

const MethodRow& find_method(MethodName name) {
    for (const MethodRow& row : methods)
        if (row.name == name) return row;
    throw std::logic_error("a method has no row in the table of methods");
}

}  // namespace pencil
