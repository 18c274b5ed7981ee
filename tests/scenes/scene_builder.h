// Scenes built in memory and rendered on the device, for the law tests.
#pragma once

#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "render/render.h"
#include "scenes/scene_parts.h"

namespace pencil::test {

/// $PENCIL_DEVICE selects the device of all device tests.
inline std::shared_ptr<Device> device() {
    const char* selector = std::getenv("PENCIL_DEVICE");
    static const std::shared_ptr<Device> opened = Device::open(selector != nullptr ? selector : "");
    return opened;
}

/// Options of the line method, which most laws are about.
inline RenderOptions line_options() {
    RenderOptions options;
    options.method = MethodName::line;
    return options;
}

inline RenderResult render_layers(const Scene& scene, RenderOptions options, const std::vector<std::string>& aovs = {}) {
    options.aovs = aovs;
    return render(scene, options, device());
}

inline const Layer& layer(const RenderResult& result, const std::string& name) { return layer(result.layers, name); }

}  // namespace pencil::test
