// Scenes built in memory and rendered on the device, for the law tests.
#pragma once

#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "scenes/scene_parts.h"
#include "render/render.h"

namespace pencil::test {

/// $PENCIL_DEVICE selects the device of all device tests.
inline std::shared_ptr<Device> device() {
    const char* selector = std::getenv("PENCIL_DEVICE");
    static const std::shared_ptr<Device> opened = Device::open(selector != nullptr ? selector : "");
    return opened;
}

inline RenderResult render_layers(const Scene& scene, const RenderOptions& options, const std::vector<std::string>& aovs = {}) {
    return render(scene, options, aovs, device());
}

inline const Layer& layer(const RenderResult& result, const std::string& name) { return layer(result.layers, name); }

}  // namespace pencil::test
