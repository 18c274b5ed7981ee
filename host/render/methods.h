// The table of methods: the only place that knows which there are. A new method is a folder of its own and a row here.
#pragma once

#include <memory>

#include "film/method.h"
#include "film/render_context.h"

namespace pencil {

struct MethodRow {
    MethodName name;
    NeedsOf needs;
    std::unique_ptr<Method> (*make)(RenderContext& context);  // `context` was made with `needs`
};

const MethodRow& find_method(MethodName name);

}  // namespace pencil
