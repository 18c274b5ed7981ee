// The whole of a render: the steps of a session to their end, through checkpoints and over devices that fail.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "cl/device.h"
#include "options/render_options.h"
#include "options/render_result.h"
#include "scene/scene.h"

namespace pencil {

/// What is done so that no work is lost.
struct RenderCare {
    std::filesystem::path checkpoint;              // written as the render goes; empty: none
    std::filesystem::path resume;                  // a checkpoint to go on from; empty: none
    std::vector<std::shared_ptr<Device>> helpers;  // devices that share the work
    /// Another device where one has failed, null if there is none: what was finished is taken along.
    std::function<std::shared_ptr<Device>(const Device& failed)> next_device;
};

/// All steps of a session, and photometric layers if they are asked for: illuminance is a session of its own. Errors as RenderSession's, and
/// read_checkpoint's; a device that fails after the first step leaves what is finished (RenderResult::failure).
RenderResult render(const Scene& scene, const RenderOptions& options, const std::shared_ptr<Device>& device, const Progress& progress = {},
                    const RenderCare& care = {});

}  // namespace pencil
